package rsal.navigation.recovery;

import java.time.Duration;
import java.time.Instant;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Obstacles;

/// Drives the robot out of where it makes no progress, in place of its controller. One for each goal; it may keep
/// what it did. All calls on the run's thread, ten times a second while the robot is on its way.
public interface Recovery {
    /// What is known at a step.
    ///
    /// @param motion where the robot is by odometry, and how it moves
    /// @param stalled whether it pushes against something that it does not see
    /// @param obstacles what is around, in the base frame [m]; valid during the call only
    /// @param seesBehind whether a sensor looks straight back
    /// @param knowsBehind whether it sees behind, or walls there are taken from the map
    /// @param atGoal whether it is at the goal's place, where only the turn to the goal's heading is missing
    /// @param turn by what angle to turn to go on [rad]: to the path, at the goal's place to its heading
    /// @param ahead how far the path goes on straight from here [m]; 0 at the goal's place
    /// @param withoutProgress for how long, or since the last recovery
    /// @param mapFromProgress where the robot was when it last made progress
    /// @param tried how many recoveries began since it last made progress
    record Situation(
            Instant now,
            Pose2d mapFromBase,
            Motion motion,
            boolean stalled,
            Obstacles obstacles,
            boolean seesBehind,
            boolean knowsBehind,
            boolean atGoal,
            double turn,
            double ahead,
            Duration withoutProgress,
            Pose2d mapFromProgress,
            int tried) {
        /// Whether it pushes against something, or makes no progress for longer than this.
        public boolean isStuck(Duration after) {
            return stalled || withoutProgress.compareTo(after) > 0;
        }
    }

    enum State {
        RUNNING,
        DONE,
        /// It can do nothing here: the next recovery begins at once.
        FAILED
    }

    /// Whether to begin now. Of several, the first one in the order of the navigator's list begins.
    boolean isDue(Situation situation);

    void begin(Situation situation);

    /// Asked before each command, and after it.
    State state(Situation situation);

    /// What to command now. The recovery itself ensures that the robot collides with nothing.
    Twist2d command(Situation situation);

    /// Whether it follows a path of its own to where this goal is. Such a recovery ends when another goal comes.
    default boolean followsOwnPath() {
        return false;
    }
}
