package rsal.player.message;

/// A place in space [m].
public record Point3(double x, double y, double z) {}
