package rsal.engine.report;

import java.time.Duration;
import java.util.Optional;
import rsal.data.Pose2d;

/// A place to which somebody sent a robot, and what became of that.
///
/// @param id from 1, in the order in which they were given
/// @param sent when, since the run's start
/// @param ended when, since the run's start; empty while it is under way
/// @param why it did not get there, for people; empty otherwise
public record SentGoal(
        int id, String robot, Pose2d mapFromGoal, Status status, Duration sent, Optional<Duration> ended, String why) {
    /// As `action_msgs/GoalStatus` of ROS 2 has them.
    public enum Status {
        EXECUTING("executing"),
        SUCCEEDED("succeeded"),
        CANCELED("canceled"),
        ABORTED("aborted");

        private final String word;

        Status(String word) {
            this.word = word;
        }

        public String word() {
            return word;
        }
    }

    public SentGoal ended(Status how, Duration now, String reason) {
        return new SentGoal(id, robot, mapFromGoal, how, sent, Optional.of(now), reason);
    }

    public boolean isInProgress() {
        return status == Status.EXECUTING;
    }
}
