package rsal.sim.world;

import java.util.List;
import rsal.data.Pose2d;
import rsal.robot.Shift;

/// A body's pieces, all placed with its base.
final class Figure {
    final Piece[] pieces;
    private final double radius;
    private Pose2d pose = Pose2d.ORIGIN;
    private double cos = 1;
    private double sin;
    private double height;

    /// Placed at the origin.
    Figure(List<Chunk> chunks) {
        pieces = chunks.stream()
                .map(chunk -> switch (chunk) {
                    case Chunk.Prism prism -> new Polygon(prism);
                    case Chunk.Cylinder cylinder -> new Disc(cylinder);
                })
                .toArray(Piece[]::new);
        double farthest = 0;
        for (Chunk chunk : chunks) {
            farthest = Math.max(
                    farthest,
                    switch (chunk) {
                        case Chunk.Prism prism -> prism.outline().farthest;
                        case Chunk.Cylinder c ->
                            Math.hypot(c.center().x(), c.center().y()) + c.radius();
                    });
        }
        radius = farthest;
    }

    /// @param height above ground [m]
    void placeAt(Pose2d mapFromBase, double height) {
        place(mapFromBase, StrictMath.cos(mapFromBase.theta()), StrictMath.sin(mapFromBase.theta()), height);
    }

    /// Where its base would be if it had moved along; without its pieces unless it has not moved at all.
    Figure shifted(Shift shift) {
        if (shift.isNone()) {
            return this;
        }
        var frame = new Figure(List.of());
        frame.placeAt(pose.compose(shift.baseFromMoved()), height + shift.rise());
        return frame;
    }

    /// Places it where another is.
    void placeAt(Figure other) {
        place(other.pose, other.cos, other.sin, other.height);
    }

    private void place(Pose2d mapFromBase, double itsCos, double itsSin, double itsHeight) {
        pose = mapFromBase;
        cos = itsCos;
        sin = itsSin;
        height = itsHeight;
        for (Piece piece : pieces) {
            piece.place(pose.x(), pose.y(), cos, sin, height);
        }
    }

    /// mapFromBase
    Pose2d pose() {
        return pose;
    }

    /// Of its heading.
    double cos() {
        return cos;
    }

    /// Of its heading.
    double sin() {
        return sin;
    }

    /// Above ground [m].
    double height() {
        return height;
    }

    /// Of the smallest circle around the base's origin that holds it [m].
    double radius() {
        return radius;
    }
}
