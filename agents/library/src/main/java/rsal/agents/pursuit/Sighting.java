package rsal.agents.pursuit;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.agent.message.PoseReport;
import rsal.data.Pose2d;

/// An agent has seen a robot.
///
/// @param robot id of the robot that was seen
/// @param role its role
/// @param mapFromBase its pose in the map frame, when it was seen
public record Sighting(String robot, String role, Pose2d mapFromBase) implements MessageContent {
    public static final Topic<Sighting> TOPIC = new Topic<>("sighting", Sighting.class);

    public Sighting {
        MessageCheck.given("robot", robot);
        MessageCheck.given("role", role);
        MessageCheck.somewhere("robot", mapFromBase);
    }

    /// @param roleOrId of a robot
    public boolean isOf(String roleOrId) {
        return role.equals(roleOrId) || robot.equals(roleOrId);
    }

    /// The same as a robot says it of itself.
    public PoseReport report() {
        return new PoseReport(robot, role, mapFromBase);
    }

    @Override
    public String words() {
        return "I see %s at %s".formatted(robot, mapFromBase.rounded());
    }
}
