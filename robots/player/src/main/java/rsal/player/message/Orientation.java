package rsal.player.message;

/// How something is turned in space [rad].
public record Orientation(double roll, double pitch, double yaw) {}
