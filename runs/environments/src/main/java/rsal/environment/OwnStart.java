package rsal.environment;

import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Localizer;

/// Where a robot has started, by its localizer: its first estimate, which comes a little after the start of an agent.
final class OwnStart {
    private final Localizer localizer;
    private @Nullable Pose2d mapFromStart;

    OwnStart(Localizer localizer) {
        this.localizer = localizer;
    }

    /// Where the robot is as seen from its start; still there, before the first estimate.
    Pose2d startFromBase() {
        Pose2d mapFromBase = look();
        return mapFromStart == null ? Pose2d.ORIGIN : mapFromStart.inverse().compose(mapFromBase);
    }

    /// The start as seen from the robot.
    Point2d baseFromStart() {
        Pose2d mapFromBase = look();
        return mapFromStart == null
                ? Pose2d.ORIGIN.position()
                : mapFromBase.inverse().transform(mapFromStart.position());
    }

    private Pose2d look() {
        Pose2d mapFromBase = OwnPose.believed(localizer);
        if (mapFromStart == null && localizer.latest().isPresent()) {
            mapFromStart = mapFromBase;
        }
        return mapFromBase;
    }
}
