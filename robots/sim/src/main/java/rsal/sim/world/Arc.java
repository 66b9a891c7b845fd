package rsal.sim.world;

import rsal.data.Pose2d;

/// The way of a differential drive at constant speeds: part of a circle, a line, or a turn on the spot.
///
/// @param length forward [m], negative backward
/// @param turn counter-clockwise [rad]
public record Arc(Pose2d from, double length, double turn) {

    /// Where the robot is after a part of the way.
    ///
    /// @param part 0 at the start, 1 at the end
    public Pose2d at(double part) {
        double half = turn * part / 2;
        double chord = length * part * sinc(half);
        double direction = from.theta() + half;
        return new Pose2d(
                from.x() + chord * StrictMath.cos(direction),
                from.y() + chord * StrictMath.sin(direction),
                from.theta() + turn * part);
    }

    /// The longest way that any point of a body makes, at most [m].
    ///
    /// @param radius of the body around its base's origin [m]
    double longestWay(double radius) {
        return Math.abs(length) + radius * Math.abs(turn);
    }

    private static double sinc(double angle) {
        return Math.abs(angle) < 1e-4 ? 1 - angle * angle / 6 : StrictMath.sin(angle) / angle;
    }
}
