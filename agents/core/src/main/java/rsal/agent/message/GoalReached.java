package rsal.agent.message;

import rsal.agent.Topic;
import rsal.data.Pose2d;

/// A robot's drive to a place has ended.
///
/// @param ending `reached`, `cancelled`, `no path` or `stuck`
public record GoalReached(String robot, Pose2d mapFromGoal, String ending) {
    public static final Topic<GoalReached> TOPIC = new Topic<>("goal-reached", GoalReached.class);
}
