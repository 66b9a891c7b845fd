package rsal.navigation.control;

import rsal.data.Pose2d;

/// Decides what counts as progress. Without it, the navigator begins a recovery. One for each goal; it keeps where the
/// robot was when it last made progress. All calls on the run's thread, ten times a second while the robot is on its
/// way.
public interface ProgressChecker {
    /// Whether the robot made progress since this was last so.
    ///
    /// @param mapFromBase where the robot believes to be
    /// @param left what is left: on the way, the path [m] and π; at the goal's place, the turn to its heading [rad]
    boolean isProgress(Pose2d mapFromBase, double left);

    /// The robot has another path: what was left before says nothing of this one.
    ///
    /// @param left of the new path
    void onNewPath(double left);
}
