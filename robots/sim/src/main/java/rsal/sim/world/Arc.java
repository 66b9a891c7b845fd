package rsal.sim.world;

import rsal.data.Pose2d;

/// The way of a base that moves at constant speeds in its own frame: part of a circle, a line, or a turn on the
/// spot. Exact: the exponential map of SE(2) (Lynch and Park, Modern Robotics, 2017, section 3.3.3).
///
/// @param forward [m], negative backward
/// @param left [m], negative to the right; only omnidirectional drives have any
/// @param turn counter-clockwise [rad]
public record Arc(Pose2d from, double forward, double left, double turn) {

    /// The way of a drive that can't go sideways.
    public static Arc ahead(Pose2d from, double forward, double turn) {
        return new Arc(from, forward, 0, turn);
    }

    /// Where the robot is after a part of the way.
    ///
    /// @param part 0 at the start, 1 at the end
    public Pose2d at(double part) {
        double half = turn * part / 2;
        double chord = part * sinc(half);
        double direction = from.theta() + half;
        double cos = chord * StrictMath.cos(direction);
        double sin = chord * StrictMath.sin(direction);
        return new Pose2d(
                from.x() + forward * cos - left * sin,
                from.y() + forward * sin + left * cos,
                from.theta() + turn * part);
    }

    /// The longest way that any point of a body makes, at most [m].
    ///
    /// @param radius of the body around its base's origin [m]
    double longestDistance(double radius) {
        double straight = left == 0 ? Math.abs(forward) : Math.sqrt(forward * forward + left * left);
        return straight + radius * Math.abs(turn);
    }

    private static double sinc(double angle) {
        return Math.abs(angle) < 1e-4 ? 1 - angle * angle / 6 : StrictMath.sin(angle) / angle;
    }
}
