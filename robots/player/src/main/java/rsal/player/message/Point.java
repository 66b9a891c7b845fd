package rsal.player.message;

/// A place on a plane [m].
public record Point(double x, double y) {}
