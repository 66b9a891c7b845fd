package rsal.world.yaml;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.scene.Block;
import rsal.scene.Surface;
import rsal.settings.Section;
import rsal.settings.Suggestion;

/// What a thing or a robot is made of.
record SolidReader(List<Piece> pieces) {
    private static final double SPECK = 0.02; // side of a robot that has no body [m]

    SolidReader {
        pieces = List.copyOf(pieces);
    }

    /// @param prism with its color, if one is told
    /// @param surface its color does not count
    /// @param carrier the actuator that it moves with
    record Piece(Prism prism, Surface surface, Optional<String> carrier) {
        Block in(Rgb color) {
            return new Block(
                    new Prism(prism.shape(), prism.bottom(), prism.top(), Optional.empty()),
                    surface.in(prism.color().orElse(color)),
                    carrier);
        }
    }

    /// Reads a `body`: one piece, or `pieces`, which may be none.
    ///
    /// @param base what others make of pieces that say nothing of it
    static SolidReader read(Section body, Surface base) {
        return read(body, base, _ -> Optional.empty());
    }

    /// Reads the `body` of a robot, of which actuators may carry pieces.
    ///
    /// @param places where it may have devices
    static SolidReader ofRobot(Section body, Set<String> places) {
        return read(body, Surface.PLAIN, piece -> carrier(piece, places));
    }

    private static Optional<String> carrier(Section piece, Set<String> places) {
        if (!piece.has("actuator")) {
            return Optional.empty();
        }
        String carrier = piece.text("actuator");
        if (!carrier.isEmpty() && !places.contains(carrier)) {
            piece.problem(
                    "actuator",
                    "'%s' is '%s', which 'mounts' does not list.".formatted(piece.path("actuator"), carrier),
                    Suggestion.among(carrier, places));
        }
        return Optional.of(carrier);
    }

    private static SolidReader read(Section body, Surface base, Function<Section, Optional<String>> carrier) {
        Surface surface = SurfaceReader.reported(body).apply(base);
        if (!body.has("pieces")) {
            Optional<String> on = carrier.apply(body);
            return new SolidReader(List.of(new Piece(Keys.BODIES.piece(body), surface, on)));
        }
        boolean none = body.list("pieces").filter(List::isEmpty).isPresent();
        var pieces = new ArrayList<Piece>();
        for (Section piece : none ? List.<Section>of() : Keys.BODIES.pieces(body)) {
            Surface own = SurfaceReader.reported(piece).apply(surface);
            Optional<String> on = carrier.apply(piece);
            pieces.add(new Piece(Keys.BODIES.piece(piece), own, on));
        }
        body.done();
        return new SolidReader(pieces);
    }

    /// @param color of pieces that have none
    List<Block> blocks(Rgb color) {
        return List.copyOf(pieces.stream().map(piece -> piece.in(color)).toList());
    }

    /// What a robot takes for itself when it keeps out of the way: what runs into things, if anything does.
    Solid solid() {
        List<Piece> solid =
                pieces.stream().filter(piece -> piece.surface().obstacle()).toList();
        List<Prism> prisms =
                (solid.isEmpty() ? pieces : solid).stream().map(Piece::prism).toList();
        return prisms.isEmpty()
                ? Solid.standing(Shape.Polygon.of(Footprint.box(SPECK, SPECK, new Point2d(0, 0))), SPECK)
                : new Solid(prisms);
    }
}
