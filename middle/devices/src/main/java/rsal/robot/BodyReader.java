package rsal.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.settings.Section;
import rsal.settings.Value;

/// Reads the `body` of a model file: a box, a disc, an outline, or `pieces` of those.
final class BodyReader {
    private static final int MAX_PIECES = 100;
    private static final int MAX_CORNERS = 200;
    private static final Shape HARMLESS = new Shape.Disc(new Point2d(0, 0), 1);

    private BodyReader() {}

    static Solid read(Section body) {
        if (!body.has("pieces")) {
            return new Solid(List.of(piece(body)));
        }
        var pieces = new ArrayList<Prism>();
        for (Value item : body.list("pieces").orElse(List.of())) {
            if (item instanceof Value.Mapping mapping) {
                pieces.add(piece(new Section(body.path("pieces"), mapping, body.problems())));
            } else {
                body.expected("pieces", "a list of groups such as {radius: 0.2}", item);
            }
        }
        body.done();
        if (pieces.isEmpty() || pieces.size() > MAX_PIECES) {
            body.problem("pieces", "(body.pieces) must list 1 to %d pieces.".formatted(MAX_PIECES), "");
            return new Solid(List.of(Prism.standing(HARMLESS, 1)));
        }
        return new Solid(pieces);
    }

    private static Prism piece(Section piece) {
        Shape shape = shape(piece);
        double bottom = piece.has("bottom") ? Numbers.notNegative(piece, "bottom") : 0;
        double height = piece.has("height") ? Numbers.positive(piece, "height") : RobotModel.HEIGHT;
        Optional<Rgb> color = piece.has("color") ? Optional.of(color(piece, "color")) : Optional.empty();
        piece.done();
        return new Prism(shape, bottom, bottom + height, color);
    }

    private static Shape shape(Section piece) {
        if (piece.has("outline")) {
            return outline(piece);
        }
        if (piece.has("radius")) {
            return new Shape.Disc(center(piece), Numbers.positive(piece, "radius"));
        }
        double length = Numbers.positive(piece, "length");
        double width = Numbers.positive(piece, "width");
        return Shape.Polygon.of(Footprint.box(length, width, center(piece)));
    }

    private static Point2d center(Section piece) {
        double[] center = piece.numbers("center", 2).orElse(new double[2]);
        if (Math.abs(center[0]) > Numbers.MOST || Math.abs(center[1]) > Numbers.MOST) {
            piece.problem("center", "(%s) must be at most %s away.".formatted(piece.path("center"), Numbers.MOST), "");
            return new Point2d(0, 0);
        }
        return new Point2d(center[0], center[1]);
    }

    private static Shape outline(Section piece) {
        List<Value> items = piece.list("outline").orElse(List.of());
        List<Point2d> corners = items.stream()
                .limit(MAX_CORNERS)
                .flatMap(item -> piece.numbers("outline", item, 2).stream())
                .map(xy -> new Point2d(xy[0], xy[1]))
                .toList();
        if (corners.size() < items.size()) {
            if (items.size() > MAX_CORNERS) {
                piece.problem(
                        "outline",
                        "(%s) must have at most %d corners, not %d."
                                .formatted(piece.path("outline"), MAX_CORNERS, items.size()),
                        "");
            }
            return HARMLESS;
        }
        if (corners.stream().anyMatch(c -> Math.max(Math.abs(c.x()), Math.abs(c.y())) > Numbers.MOST)) {
            piece.problem(
                    "outline",
                    "Corners of (%s) must be at most %s away.".formatted(piece.path("outline"), Numbers.MOST),
                    "");
            return HARMLESS;
        }
        try {
            return new Shape.Polygon(corners);
        } catch (IllegalArgumentException e) {
            piece.problem("outline", "(%s): %s".formatted(piece.path("outline"), e.getMessage()), "");
            return HARMLESS;
        }
    }

    /// A color, or black when it can't be read.
    static Rgb color(Section section, String key) {
        String text = section.text(key);
        Optional<Rgb> color = Rgb.parse(text);
        if (color.isEmpty() && !text.isEmpty()) {
            section.problem(key, "(%s) must be a color, #rrggbb, not (%s).".formatted(section.path(key), text), "");
        }
        return color.orElse(Rgb.of(0));
    }
}
