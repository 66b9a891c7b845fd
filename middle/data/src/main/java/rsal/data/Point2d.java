package rsal.data;

/// A place in a plane [m].
public record Point2d(double x, double y) {
    public double distanceTo(Point2d other) {
        return Math.hypot(other.x - x, other.y - y);
    }
}
