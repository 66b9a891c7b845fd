package rsal.sim.world;

import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.robot.Shift;

/// A body's pieces, all placed with its base.
final class Figure {
    final PlacedShape[] pieces;
    private final @Nullable ArticulatedBody limbs; // null where no actuator carries any piece
    private final double radiusAtHome;
    private double radius;
    private Pose2d pose = Pose2d.ORIGIN;
    private double cos = 1;
    private double sin;
    private double height;
    private int places; // where it has been

    /// Placed at the origin.
    Figure(List<CollisionShape> chunks) {
        pieces = chunks.stream().map(Figure::piece).toArray(PlacedShape[]::new);
        limbs = ArticulatedBody.of(chunks, pieces).orElse(null);
        double farthest = 0;
        for (CollisionShape chunk : chunks) {
            farthest = Math.max(farthest, farthest(chunk));
        }
        radiusAtHome = farthest;
        radius = farthest;
    }

    private static PlacedShape piece(CollisionShape chunk) {
        return switch (chunk) {
            case CollisionShape.Prism prism -> new Polygon(prism);
            case CollisionShape.Cylinder cylinder -> new Disc(cylinder);
            case CollisionShape.Carried carried -> piece(carried.chunk());
        };
    }

    private static double farthest(CollisionShape chunk) {
        return switch (chunk) {
            case CollisionShape.Prism prism -> prism.outline().farthest;
            case CollisionShape.Cylinder c ->
                Math.hypot(c.center().x(), c.center().y()) + c.radius();
            case CollisionShape.Carried carried -> farthest(carried.chunk());
        };
    }

    /// The actuators that carry pieces of it.
    List<String> carriers() {
        return limbs == null ? List.of() : limbs.carriers();
    }

    /// Lets actuators carry pieces.
    ///
    /// @param shifts for each of the [#carriers]
    void bend(List<Shift> shifts) {
        if (limbs != null) {
            limbs.shift(shifts);
            place(pose, cos, sin, height);
            radius = Math.max(radiusAtHome, limbs.radius(pose));
        }
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
        if (limbs != null && other.limbs != null) {
            limbs.shift(other.limbs);
            radius = other.radius;
        }
        place(other.pose, other.cos, other.sin, other.height);
    }

    private void place(Pose2d mapFromBase, double itsCos, double itsSin, double itsHeight) {
        pose = mapFromBase;
        cos = itsCos;
        sin = itsSin;
        height = itsHeight;
        places++;
        for (PlacedShape piece : pieces) {
            piece.place(pose.x(), pose.y(), cos, sin, height);
        }
        if (limbs != null) {
            limbs.place(pose, height);
        }
    }

    /// A number that changes whenever it is placed somewhere or taken away.
    int places() {
        return places;
    }

    /// It is in nobody's way any more.
    void takeAway() {
        places++;
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

    /// Of a circle around the base's origin that holds it [m].
    double radius() {
        return radius;
    }
}
