package rsal.agent.message;

import rsal.agent.Topic;

/// Asks a robot, or all, to report its pose now.
///
/// @param robot id, or [NewGoal#ALL]
public record PoseRequest(String robot) {
    public static final Topic<PoseRequest> TOPIC = new Topic<>("pose-request", PoseRequest.class);

    public PoseRequest {
        Check.given("robot", robot);
    }

    public boolean isFor(String id) {
        return robot.equals(id) || robot.equals(NewGoal.ALL);
    }
}
