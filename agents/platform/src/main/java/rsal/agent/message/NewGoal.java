package rsal.agent.message;

import rsal.agent.Topic;
import rsal.data.Pose2d;

/// Sends a robot, or all, to a place.
///
/// @param robot id, or [#ALL]
public record NewGoal(String robot, Pose2d mapFromGoal) {
    public static final Topic<NewGoal> TOPIC = new Topic<>("new-goal", NewGoal.class);

    public static final String ALL = "all";

    public NewGoal {
        Check.given("robot", robot);
        Check.somewhere("goal", mapFromGoal);
    }

    public boolean isFor(String id) {
        return robot.equals(id) || robot.equals(ALL);
    }
}
