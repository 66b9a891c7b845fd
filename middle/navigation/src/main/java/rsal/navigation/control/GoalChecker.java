package rsal.navigation.control;

import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// Decides when a goal counts as reached. One for each goal; it may keep what it saw. All calls on the run's
/// thread, ten times a second.
public interface GoalChecker {
    /// Whether the robot is at the goal's place: then the navigator stops following the path and turns it to
    /// the goal's heading.
    ///
    /// @param mapFromBase where the robot believes to be
    /// @param velocity as odometry measures it, in the base frame
    boolean isAtPlace(Pose2d mapFromBase, Twist2d velocity);

    /// Whether the goal is reached. Asked only at its place.
    boolean isReached(Pose2d mapFromBase, Twist2d velocity);
}
