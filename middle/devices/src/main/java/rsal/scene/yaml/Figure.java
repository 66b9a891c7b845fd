package rsal.scene.yaml;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.scene.Block;
import rsal.scene.Surface;
import rsal.settings.Section;

/// What a thing or a robot is made of.
record Figure(List<Piece> pieces) {
    private static final double SPECK = 0.02; // side of a robot that has no body [m]

    Figure {
        pieces = List.copyOf(pieces);
    }

    /// @param prism with its color, if one is told
    /// @param surface its color does not count
    record Piece(Prism prism, Surface surface) {
        Block in(Rgb color) {
            return new Block(
                    new Prism(prism.shape(), prism.bottom(), prism.top(), Optional.empty()),
                    surface.in(prism.color().orElse(color)));
        }
    }

    /// Reads a `body`: one piece, or `pieces`, which may be none.
    ///
    /// @param base what others make of pieces that say nothing of it
    static Figure read(Section body, Surface base) {
        Surface surface = SurfaceReader.told(body).apply(base);
        if (!body.has("pieces")) {
            return new Figure(List.of(new Piece(Keys.BODIES.piece(body), surface)));
        }
        boolean none = body.list("pieces").filter(List::isEmpty).isPresent();
        var pieces = new ArrayList<Piece>();
        for (Section piece : none ? List.<Section>of() : Keys.BODIES.pieces(body)) {
            Surface own = SurfaceReader.told(piece).apply(surface);
            pieces.add(new Piece(Keys.BODIES.piece(piece), own));
        }
        body.done();
        return new Figure(pieces);
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
