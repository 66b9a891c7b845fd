package rsal.agents.swarm;

import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Sums of directions in the plane.
final class Vectors {
    private Vectors() {}

    static Point2d between(Pose2d from, Pose2d to) {
        return new Point2d(to.x() - from.x(), to.y() - from.y());
    }

    static Point2d polar(double length, double angle) {
        return new Point2d(length * StrictMath.cos(angle), length * StrictMath.sin(angle));
    }

    static Point2d sum(Point2d one, double factor, Point2d other) {
        return new Point2d(one.x() + factor * other.x(), one.y() + factor * other.y());
    }

    static double length(Point2d vector) {
        return Math.sqrt(vector.x() * vector.x() + vector.y() * vector.y());
    }

    static double angle(Point2d vector) {
        return StrictMath.atan2(vector.y(), vector.x());
    }

    /// The same direction; (0, 0) stays what it is.
    static Point2d withLength(Point2d vector, double length) {
        double old = length(vector);
        return old == 0 ? vector : new Point2d(vector.x() * length / old, vector.y() * length / old);
    }

    static Point2d atMost(Point2d vector, double length) {
        return length(vector) > length ? withLength(vector, length) : vector;
    }
}
