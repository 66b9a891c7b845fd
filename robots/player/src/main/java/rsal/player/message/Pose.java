package rsal.player.message;

/// Where something is on a plane [m, rad].
public record Pose(double x, double y, double theta) {}
