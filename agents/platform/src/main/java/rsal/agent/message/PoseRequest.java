package rsal.agent.message;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;

/// Asks a robot, or all, to report its pose now.
///
/// @param robot id, or [NewGoal#ALL]
public record PoseRequest(String robot) implements MessageContent {
    public static final Topic<PoseRequest> TOPIC = new Topic<>("pose-request", PoseRequest.class);

    public PoseRequest {
        MessageCheck.given("robot", robot);
    }

    public boolean isFor(String id) {
        return robot.equals(id) || robot.equals(NewGoal.ALL);
    }

    @Override
    public String words() {
        return "%s, where are you?".formatted(robot);
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
