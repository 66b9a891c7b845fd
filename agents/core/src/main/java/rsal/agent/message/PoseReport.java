package rsal.agent.message;

import rsal.agent.Topic;
import rsal.data.Pose2d;

/// Where a robot believes to be.
///
/// @param robot its id
/// @param role its role, as the scenario calls it
/// @param mapFromBase its pose in the map frame
public record PoseReport(String robot, String role, Pose2d mapFromBase) {
    public static final Topic<PoseReport> TOPIC = new Topic<>("pose", PoseReport.class);

    public PoseReport {
        if (!mapFromBase.isFinite()) {
            throw new IllegalArgumentException("A robot must be somewhere, not at (%s).".formatted(mapFromBase));
        }
    }

    /// @param roleOrId of a robot
    public boolean isFrom(String roleOrId) {
        return role.equals(roleOrId) || robot.equals(roleOrId);
    }
}
