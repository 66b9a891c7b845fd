package rsal.player.message;

/// Where something is in space [m, rad].
public record Pose3(double x, double y, double z, double roll, double pitch, double yaw) {}
