package rsal.player.device;

import rsal.data.Pose2d;
import rsal.player.message.Pose;
import rsal.player.message.Pose3;

/// Poses of Player's as ours.
final class Poses {
    private Poses() {}

    static Pose2d of(Pose pose) {
        return new Pose2d(pose.x(), pose.y(), pose.theta());
    }

    /// Seen from above. Stage leaves what it does not know of a pose as it is in memory, so nothing else is looked at.
    static Pose2d of(Pose3 pose) {
        return new Pose2d(pose.x(), pose.y(), pose.yaw());
    }

    static Pose of(Pose2d pose) {
        return new Pose(pose.x(), pose.y(), pose.theta());
    }
}
