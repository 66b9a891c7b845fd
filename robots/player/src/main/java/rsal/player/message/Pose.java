package rsal.player.message;

import rsal.data.Pose2d;

/// Where something is on a plane [m, rad].
public record Pose(double x, double y, double theta) {
    public static Pose of(Pose2d pose) {
        return new Pose(pose.x(), pose.y(), pose.theta());
    }

    public Pose2d to2d() {
        return new Pose2d(x, y, theta);
    }
}
