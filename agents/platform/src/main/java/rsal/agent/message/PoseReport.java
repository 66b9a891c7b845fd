package rsal.agent.message;

import java.util.Optional;
import java.util.function.Supplier;
import rsal.agent.Interest;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.data.Pose2d;

/// The estimated pose of a robot.
///
/// @param robot its id
/// @param role its role, as the scenario calls it
/// @param mapFromBase its pose in the map frame
public record PoseReport(String robot, String role, Pose2d mapFromBase) implements MessageContent {
    public static final Topic<PoseReport> TOPIC = new Topic<>("pose", PoseReport.class);

    public PoseReport {
        MessageCheck.given("robot", robot);
        MessageCheck.given("role", role);
        MessageCheck.somewhere("robot", mapFromBase);
    }

    /// @param roleOrId of a robot
    public boolean isFrom(String roleOrId) {
        return role.equals(roleOrId) || robot.equals(roleOrId);
    }

    /// Interest in poses of robots of a role, or of the one with that id.
    public static Interest<PoseReport> ofRobots(String roleOrId) {
        return Interest.in(report -> report.isFrom(roleOrId));
    }

    /// Interest in poses nearer than that; in none while it does not know where it is itself.
    ///
    /// @param radius [m]
    /// @param mapFromBase where it is now
    public static Interest<PoseReport> within(double radius, Supplier<Optional<Pose2d>> mapFromBase) {
        return Interest.in(report -> mapFromBase
                .get()
                .filter(here -> here.distanceTo(report.mapFromBase()) <= radius)
                .isPresent());
    }

    @Override
    public String words() {
        return "%s is at %s".formatted(robot, mapFromBase.rounded());
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
