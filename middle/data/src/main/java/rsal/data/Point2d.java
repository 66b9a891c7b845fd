package rsal.data;

import java.util.Locale;

/// A place in a plane [m].
public record Point2d(double x, double y) {
    public double distanceTo(Point2d other) {
        return Math.hypot(other.x - x, other.y - y);
    }

    /// For people, in centimeters: `(1.23, -4.50)`.
    public String rounded() {
        return String.format(Locale.ROOT, "(%.2f, %.2f)", x, y);
    }
}
