package rsal.navigation.avoid;

import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// A controller, or local planner: says what to command now, so that a robot comes nearer to where it is sent
/// and collides with nothing on its path. All points are in the robot's base frame [m].
///
/// Keeps what it did last, so each robot needs its own, on one thread.
public interface Controller {
    /// How many points [#path] has at most.
    int PATH_POINTS = 16;

    /// Where to go.
    ///
    /// @param place to head for
    /// @param arriving whether to come to rest there
    /// @param path the next piece of the planned way, from the robot to the place and on; empty when nobody planned
    record Target(Point2d place, boolean arriving, List<Point2d> path) {
        public Target {
            path = List.copyOf(path);
        }

        /// A place to which nobody planned a way.
        public static Target at(Point2d place, boolean arriving) {
            return new Target(place, arriving, List.of());
        }

        /// [m]
        public double distance() {
            return Math.hypot(place.x(), place.y());
        }

        /// [rad]
        public double bearing() {
            return Math.atan2(place.y(), place.x());
        }
    }

    /// How the robot moves.
    ///
    /// @param odomFromBase where odometry says that it is; smooth, drifts
    /// @param velocity measured
    record Motion(Pose2d odomFromBase, Twist2d velocity) {}

    /// The command that brings the robot nearer to a target; [Twist2d#STOP] when there is none.
    Twist2d drive(Obstacles obstacles, Target target, Motion motion);

    /// The command that turns the robot by an angle [rad], in place unless it is too long for that.
    Twist2d turn(Obstacles obstacles, double angle, Motion motion);

    /// What of somebody else's command is safe.
    Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion);

    /// The way that it means to go on by what it commanded last, for people to see: places of the base one after the
    /// other, in the base frame as that was then [m], the first of them its origin; at most [#PATH_POINTS].
    /// Made when it is asked for. Empty where it stands or turns in place, and of one that tells none.
    default List<Point2d> predictedTrajectory() {
        return List.of();
    }

    /// Forgets what it did, as when the robot has been carried away.
    void reset();
}
