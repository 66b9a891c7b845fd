package rsal.stage;

/// From the least to the greatest value; the unit is that of whatever it bounds.
public record ValueRange(double min, double max) {}
