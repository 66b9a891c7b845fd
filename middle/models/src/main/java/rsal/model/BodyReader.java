package rsal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.robot.RobotModel;
import rsal.settings.ColorNames;
import rsal.settings.Section;
import rsal.settings.Value;

/// Reads bodies: boxes, discs, outlines, or `pieces` of those. What is wrong is noted, and something harmless taken.
public final class BodyReader {
    /// For the bodies of robots.
    static final BodyReader ROBOTS = new BodyReader(new Limits(100, 200, NumberReader.MOST, 0, RobotModel.HEIGHT));

    private static final double THINNEST = 1e-9; // [m]
    private static final Shape HARMLESS = new Shape.Disc(new Point2d(0, 0), 1);

    private final Limits limits;

    public BodyReader(Limits limits) {
        this.limits = limits;
    }

    /// What bodies can be.
    ///
    /// @param pieces at most
    /// @param corners of an outline, at most
    /// @param most that anything can be long or away from the middle [m]
    /// @param lowest underside above the floor [m]
    /// @param height of pieces for which none is told [m]
    public record Limits(int pieces, int corners, double most, double lowest, double height) {}

    /// A group that is a box, a disc or an outline, or lists `pieces` of those.
    public Solid read(Section body) {
        if (!body.has("pieces")) {
            return new Solid(List.of(piece(body)));
        }
        List<Prism> pieces = pieces(body).stream().map(this::piece).toList();
        body.done();
        return pieces.isEmpty() ? new Solid(List.of(Prism.standing(HARMLESS, 1))) : new Solid(pieces);
    }

    /// The groups that `pieces` lists; none when there are too few or too many.
    public List<Section> pieces(Section body) {
        var pieces = new ArrayList<Section>();
        for (Value item : body.list("pieces").orElse(List.of())) {
            if (item instanceof Value.Mapping mapping) {
                pieces.add(new Section(body.path("pieces"), mapping, body.problems()));
            } else {
                body.expected("pieces", "a list of groups such as {radius: 0.2}", item);
            }
        }
        if (pieces.isEmpty() || pieces.size() > limits.pieces) {
            body.problem("pieces", "'%s' must list 1 to %d pieces.".formatted(body.path("pieces"), limits.pieces), "");
            return List.of();
        }
        return pieces;
    }

    /// Reads all that is left of a group as one piece.
    public Prism piece(Section piece) {
        Shape shape = shape(piece);
        double bottom = piece.has("bottom") ? NumberReader.checked(piece, "bottom", limits.lowest, limits.most) : 0;
        double height =
                piece.has("height") ? NumberReader.checked(piece, "height", THINNEST, limits.most) : limits.height;
        Optional<Rgb> color = piece.has("color") ? Optional.of(color(piece, "color")) : Optional.empty();
        piece.done();
        return new Prism(shape, bottom, Math.max(bottom + height, Math.nextUp(bottom)), color);
    }

    /// A box, a disc or an outline.
    public Shape shape(Section piece) {
        if (piece.has("outline")) {
            return outline(piece);
        }
        if (piece.has("radius")) {
            return new Shape.Disc(center(piece), length(piece, "radius"));
        }
        double length = length(piece, "length");
        double width = length(piece, "width");
        Point2d center = center(piece);
        try {
            return Shape.Polygon.of(Footprint.box(length, width, center));
        } catch (IllegalArgumentException _) { // too thin for numbers so far away
            piece.problem(piece.location(), "'%s' is too thin.".formatted(piece.path("")), "");
            return HARMLESS;
        }
    }

    private double length(Section piece, String key) {
        return NumberReader.checked(piece, key, NumberReader.LEAST, limits.most);
    }

    private Point2d center(Section piece) {
        double[] center = piece.numbers("center", 2).orElse(new double[2]);
        if (Math.abs(center[0]) > limits.most || Math.abs(center[1]) > limits.most) {
            piece.problem("center", "'%s' must be at most %s away.".formatted(piece.path("center"), limits.most), "");
            return new Point2d(0, 0);
        }
        return new Point2d(center[0], center[1]);
    }

    private Shape outline(Section piece) {
        List<Point2d> corners = points(piece, "outline");
        if (corners.isEmpty()) {
            return HARMLESS;
        }
        try {
            return new Shape.Polygon(corners);
        } catch (IllegalArgumentException e) {
            piece.problem("outline", "'%s': %s".formatted(piece.path("outline"), e.getMessage()), "");
            return HARMLESS;
        }
    }

    /// `[[x, y], …]`; none when an error was noted.
    public List<Point2d> points(Section piece, String key) {
        List<Value> items = piece.list(key).orElse(List.of());
        if (items.isEmpty() || items.size() > limits.corners) {
            piece.problem(
                    key,
                    items.isEmpty()
                            ? "'%s' must list corners [x, y].".formatted(piece.path(key))
                            : "'%s' must have at most %d corners, not %d."
                                    .formatted(piece.path(key), limits.corners, items.size()),
                    "");
            return List.of();
        }
        List<Point2d> points = items.stream()
                .flatMap(item -> piece.numbers(key, item, 2).stream())
                .map(xy -> new Point2d(xy[0], xy[1]))
                .toList();
        if (points.stream().anyMatch(c -> Math.max(Math.abs(c.x()), Math.abs(c.y())) > limits.most)) {
            piece.problem(key, "Corners of '%s' must be at most %s away.".formatted(piece.path(key), limits.most), "");
            return List.of();
        }
        return points.size() < items.size() ? List.of() : points;
    }

    /// A color, or black when it can't be read.
    public static Rgb color(Section section, String key) {
        Optional<Value> value = section.find(key);
        if (value.isEmpty()) {
            section.text(key); // notes that it is missing
        }
        return value.flatMap(read -> ColorNames.read(section, key, read)).orElse(Rgb.of(0));
    }
}
