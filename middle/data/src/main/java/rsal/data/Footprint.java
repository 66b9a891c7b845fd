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
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            Point2d c = corners.get((i + 2) % corners.size());
            double turn = (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
            if (!(turn > 0)) {
                throw new IllegalArgumentException(
                        "A footprint turns left at every corner; this one does not at (%s, %s)."
                                .formatted(b.x(), b.y()));
            }
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
