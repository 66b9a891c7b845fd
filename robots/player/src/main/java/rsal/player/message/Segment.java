package rsal.player.message;

/// A stretch of a line [m].
public record Segment(double x0, double y0, double x1, double y1) {}
