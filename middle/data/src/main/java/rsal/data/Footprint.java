package rsal.data;

import java.util.List;

/// Outline of a body in its base frame: corners [m] of a convex polygon, counter-clockwise, around the origin or
/// beside it.
public record Footprint(List<Point2d> corners) {
    public Footprint {
        corners = List.copyOf(corners);
        if (corners.size() < 3) {
            throw new IllegalArgumentException(
                    "A footprint needs at least 3 corners, not %d.".formatted(corners.size()));
        }
        for (int i = 0; i < corners.size(); i++) {
            for (int j = 2; j < corners.size(); j++) {
                requireLeft(
                        corners.get(i), corners.get((i + 1) % corners.size()), corners.get((i + j) % corners.size()));
            }
        }
    }

    private static void requireLeft(Point2d from, Point2d to, Point2d corner) {
        double turn = (to.x() - from.x()) * (corner.y() - to.y()) - (to.y() - from.y()) * (corner.x() - to.x());
        if (!(turn > 0)) {
            throw new IllegalArgumentException(
                    "A footprint is convex and counter-clockwise: (%s, %s) must be left of its edge from (%s, %s) to (%s, %s)."
                            .formatted(corner.x(), corner.y(), from.x(), from.y(), to.x(), to.y()));
        }
    }

    /// A box of given size [m] around a center.
    public static Footprint box(double length, double width, Point2d center) {
        double l = length / 2;
        double w = width / 2;
        return new Footprint(List.of(
                new Point2d(center.x() - l, center.y() - w),
                new Point2d(center.x() + l, center.y() - w),
                new Point2d(center.x() + l, center.y() + w),
                new Point2d(center.x() - l, center.y() + w)));
    }

    /// Radius of the smallest circle around the base's origin that holds the body [m].
    public double circumscribedRadius() {
        return corners.stream().mapToDouble(c -> Math.hypot(c.x(), c.y())).max().orElseThrow();
    }

    /// Radius of the largest circle around the base's origin inside the body [m]; 0 when the origin is outside.
    public double inscribedRadius() {
        double radius = Double.POSITIVE_INFINITY;
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            double cross = a.x() * b.y() - a.y() * b.x(); // twice the triangle origin, a, b
            radius = Math.min(radius, cross / a.distanceTo(b));
        }
        return Math.max(0, radius);
    }
}
