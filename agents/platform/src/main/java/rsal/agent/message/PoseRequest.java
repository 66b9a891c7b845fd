package rsal.agent.message;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;

/// Asks one robot or all robots to report their poses now.
///
/// @param robot its id, or [NewGoal#ALL]
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
