package rsal.data;

import java.util.List;

/// A way through the map: points [m] to pass one after the other, start and goal included.
public record Path2d(List<Point2d> points) {
    public static final Path2d EMPTY = new Path2d(List.of());

    public Path2d {
        points = List.copyOf(points);
    }

    /// Length of all legs [m].
    public double length() {
        double length = 0;
        for (int i = 1; i < points.size(); i++) {
            length += points.get(i - 1).distanceTo(points.get(i));
        }
        return length;
    }
}
