package rsal.stage;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Surface;

/// Turns bodies of models into pieces with simple outlines.
final class Pieces {
    private static final int MOST_RECTANGLES = 50_000; // of an image
    private static final double THIN = 0.001; // of what has no thickness [m]

    private final WorldProblems findings;

    Pieces(WorldProblems findings) {
        this.findings = findings;
    }

    /// A piece of which the color may still be open.
    ///
    /// @param surface its color counts only when it is not drawn
    /// @param drawn whether its color is that of its owner, drawn at random
    /// @param carrier the actuator that it moves with
    record Piece(Prism prism, Surface surface, boolean drawn, Optional<String> carrier) {
        Block in(Rgb color) {
            return new Block(prism, drawn ? surface.in(color) : surface, carrier);
        }

        Piece on(Optional<String> actuator) {
            return new Piece(prism, surface, drawn, actuator);
        }
    }

    /// All of a model's body, bitmaps as rectangles.
    ///
    /// @param frameFromModel where the model is in the frame of the pieces
    List<Piece> of(StageModel model, Placement frameFromModel) {
        return of(model, model.traits().body(), frameFromModel);
    }

    /// A part of a model's body.
    List<Piece> of(StageModel model, SolidBody body, Placement frameFromModel) {
        var pieces = new ArrayList<Piece>();
        for (SolidBody.Prism prism : body.prisms()) {
            add(pieces, model, prism, frameFromModel);
        }
        body.raster().ifPresent(raster -> {
            List<int[]> rectangles = raster.bitmap().rectangles(MOST_RECTANGLES);
            if (rectangles.size() > MOST_RECTANGLES) {
                throw findings.fatal(
                        model.location(),
                        "The image of '%s' has more than %d pieces, too many for what is turned or moves."
                                .formatted(WorldProblems.shortened(model.macro()), MOST_RECTANGLES),
                        "Use a simpler image, or turn the image itself.");
            }
            for (int[] r : rectangles) {
                List<Point2d> corners = List.of(
                        corner(raster, r[0], r[2]),
                        corner(raster, r[1], r[2]),
                        corner(raster, r[1], r[3]),
                        corner(raster, r[0], r[3]));
                add(pieces, model, new SolidBody.Prism(corners, raster.heights(), Optional.empty()), frameFromModel);
            }
        });
        return pieces;
    }

    private static Point2d corner(SolidBody.Raster raster, int column, int row) {
        return raster.modelFromCorner().transform(new Point2d(column * raster.cellLength(), row * raster.cellWidth()));
    }

    private void add(List<Piece> pieces, StageModel model, SolidBody.Prism prism, Placement frameFromModel) {
        Traits traits = model.traits();
        Optional<StageColor> color = prism.color().or(traits::color);
        Surface surface = surface(traits.returns(), color.orElse(StageColor.RED));
        List<Point2d> corners =
                prism.outline().stream().map(frameFromModel.pose()::transform).toList();
        double bottom = frameFromModel.z()
                + Math.min(prism.heights().min(), prism.heights().max());
        double top = frameFromModel.z()
                + Math.max(prism.heights().min(), prism.heights().max());
        shape(corners, model)
                .ifPresent(shape -> pieces.add(new Piece(
                        new Prism(shape, bottom, Math.max(top, bottom + THIN), Optional.empty()),
                        surface,
                        color.isEmpty(),
                        Optional.empty())));
    }

    static Surface surface(Traits.Returns returns, StageColor color) {
        return new Surface(
                Rgb.of(color.rgb()),
                returns.obstacle(),
                returns.ranger(),
                returns.blob(),
                returns.fiducial(),
                returns.fiducialKey(),
                returns.gripper());
    }

    /// The outline, or the nearest to it that is one.
    private Optional<Shape> shape(List<Point2d> corners, StageModel model) {
        List<Point2d> distinct = withoutRepeats(corners);
        if (distinct.size() > 2) {
            try {
                return Optional.of(new Shape.Polygon(distinct));
            } catch (IllegalArgumentException _) {
                Optional<Shape> hull = hull(distinct);
                if (hull.isPresent()) {
                    findings.warn(
                            model.location(),
                            "A block of '%s' has an outline that meets itself; the outline around it is taken instead."
                                    .formatted(WorldProblems.shortened(model.macro())),
                            "Write its points in order, each once, or make two blocks of it.");
                    return hull;
                }
            }
        }
        return distinct.size() > 1 ? Optional.of(line(distinct)) : Optional.empty();
    }

    private static List<Point2d> withoutRepeats(List<Point2d> corners) {
        var kept = new ArrayList<Point2d>();
        for (Point2d corner : corners) {
            if (kept.isEmpty() || !kept.getLast().equals(corner)) {
                kept.add(corner);
            }
        }
        if (kept.size() > 1 && kept.getLast().equals(kept.getFirst())) {
            kept.removeLast();
        }
        return kept;
    }

    private static Optional<Shape> hull(List<Point2d> corners) {
        try {
            return Optional.of(Shape.Polygon.of(Footprint.around(corners)));
        } catch (IllegalArgumentException _) {
            return Optional.empty(); // all in a line
        }
    }

    /// A thin wall along corners that are all in a line.
    private static Shape line(List<Point2d> corners) {
        Point2d from = corners.getFirst();
        Point2d to = from;
        for (Point2d corner : corners) {
            to = corner.distanceTo(from) > to.distanceTo(from) ? corner : to;
        }
        for (Point2d corner : corners) {
            from = corner.distanceTo(to) > from.distanceTo(to) ? corner : from;
        }
        double length = from.distanceTo(to);
        var frame = new Pose2d(from.x(), from.y(), Math.atan2(to.y() - from.y(), to.x() - from.x()));
        return new Shape.Polygon(List.of(
                frame.transform(new Point2d(0, -THIN / 2)),
                frame.transform(new Point2d(length, -THIN / 2)),
                frame.transform(new Point2d(length, THIN / 2)),
                frame.transform(new Point2d(0, THIN / 2))));
    }
}
