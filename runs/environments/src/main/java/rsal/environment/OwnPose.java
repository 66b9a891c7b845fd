package rsal.environment;

import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.robot.Robot;

/// Where a robot believes itself to be, for observations.
final class OwnPose {
    private OwnPose() {}

    /// @param observation that needs it
    /// @throws IllegalArgumentException when the robot has none
    static Localizer localizer(Robot robot, String observation) {
        return robot.find(Localizer.class)
                .orElseThrow(() -> new IllegalArgumentException(
                        "Robot '%s' has no localizer for the observation '%s'. Maybe from: truth?"
                                .formatted(robot.id(), observation)));
    }

    /// Where a localizer believes the robot to be: base in `map`; the origin before its first estimate.
    static Pose2d believed(Localizer localizer) {
        return localizer.latest().map(newest -> newest.value().mapFromBase()).orElse(Pose2d.ORIGIN);
    }
}
