package rsal.player.message;

import rsal.data.Pose2d;

/// Where something is in space [m, rad].
public record Pose3(double x, double y, double z, double roll, double pitch, double yaw) {
    /// On the floor, upright.
    public static Pose3 of(Pose2d pose) {
        return new Pose3(pose.x(), pose.y(), 0, 0, 0, pose.theta());
    }

    /// Seen from above. Stage leaves what it does not know of a pose as it is in memory, so nothing else is looked at.
    public Pose2d to2d() {
        return new Pose2d(x, y, yaw);
    }
}
