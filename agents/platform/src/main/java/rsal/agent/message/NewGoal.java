package rsal.agent.message;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.data.Pose2d;

/// Sends one robot or all robots to a goal.
///
/// @param robot its id, or [#ALL]
/// @param mapFromGoal the goal, in the map frame
public record NewGoal(String robot, Pose2d mapFromGoal) implements MessageContent {
    public static final Topic<NewGoal> TOPIC = new Topic<>("new-goal", NewGoal.class);

    public static final String ALL = "all";

    public NewGoal {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("goal", mapFromGoal);
    }

    public boolean isFor(String id) {
        return robot.equals(id) || robot.equals(ALL);
    }

    @Override
    public String words() {
        return "%s, go to %s".formatted(robot, mapFromGoal.rounded());
    }

    @Override
    public Optional<String> eventKind() {
        return Optional.of("goal");
    }
}
