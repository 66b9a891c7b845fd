package rsal.data;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/// Outline of a body in its base frame: corners [m] of a convex polygon, counter-clockwise, around the origin or
/// beside it.
public record Footprint(List<Point2d> corners) {
    /// Share of the outline's extent squared by which a corner may be right of an edge. Corners that are in a line, and
    /// outlines that were moved or rotated, are so by rounding; they are out of line by this share of the extent.
    private static final double ROUNDING = 1e-12;

    public Footprint {
        corners = List.copyOf(corners);
        if (corners.size() < 3) {
            throw new IllegalArgumentException(
                    "A footprint needs at least 3 corners, not %d.".formatted(corners.size()));
        }
        double extent = extent(corners);
        double slack = ROUNDING * extent * extent; // [m²]
        for (int i = 0; i < corners.size(); i++) {
            Point2d from = corners.get(i);
            Point2d to = corners.get((i + 1) % corners.size());
            if (from.equals(to)) {
                throw new IllegalArgumentException(
                        "A footprint passes each of its corners once, (%s, %s) twice.".formatted(to.x(), to.y()));
            }
            for (int j = 2; j < corners.size(); j++) {
                requireLeft(from, to, corners.get((i + j) % corners.size()), slack);
            }
        }
        if (!(twiceArea(corners) > slack)) {
            throw new IllegalArgumentException("A footprint encloses an area; its corners are in a line.");
        }
    }

    private static void requireLeft(Point2d from, Point2d to, Point2d corner, double slack) {
        if (!(turn(from, to, corner) >= -slack)) {
            throw new IllegalArgumentException(
                    "A footprint is convex and counter-clockwise: (%s, %s) must be left of its edge from (%s, %s) to (%s, %s)."
                            .formatted(corner.x(), corner.y(), from.x(), from.y(), to.x(), to.y()));
        }
    }

    /// Twice the area [m²] inside an outline, positive when it is counter-clockwise.
    static double twiceArea(List<Point2d> corners) {
        double twice = 0;
        for (int i = 0; i < corners.size(); i++) {
            twice += turn(corners.getFirst(), corners.get(i), corners.get((i + 1) % corners.size()));
        }
        return twice;
    }

    /// Whether corners enclose no area, up to rounding.
    static boolean isFlat(List<Point2d> corners) {
        double extent = extent(corners);
        return !(Math.abs(twiceArea(corners)) > ROUNDING * extent * extent);
    }

    /// The greatest distance of a point from the first [m].
    private static double extent(List<Point2d> points) {
        return points.stream().mapToDouble(points.getFirst()::distanceTo).max().orElseThrow();
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

    /// The smallest outline around points, by Andrew's monotone chain (1979). It starts at the leftmost.
    ///
    /// @throws IllegalArgumentException when all are in a line
    public static Footprint around(List<Point2d> points) {
        List<Point2d> sorted = points.stream()
                .distinct()
                .sorted(Comparator.comparingDouble(Point2d::x).thenComparingDouble(Point2d::y))
                .toList();
        List<Point2d> hull = chain(sorted);
        hull.addAll(chain(sorted.reversed()));
        return new Footprint(hull);
    }

    /// The outline's right side on the way from the first point to the last, which is left out.
    private static List<Point2d> chain(List<Point2d> sorted) {
        var chain = new ArrayList<Point2d>();
        for (Point2d point : sorted) {
            while (chain.size() > 1 && turn(chain.get(chain.size() - 2), chain.getLast(), point) <= 0) {
                chain.removeLast();
            }
            chain.add(point);
        }
        chain.removeLast();
        return chain;
    }

    /// Positive when the way over three points turns left; twice the area of their triangle.
    static double turn(Point2d a, Point2d b, Point2d c) {
        return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
    }

    /// Radius of the smallest circle around the base's origin that holds the body [m].
    public double circumscribedRadius() {
        return corners.stream().mapToDouble(c -> Math.hypot(c.x(), c.y())).max().orElseThrow();
    }

    /// How far the body reaches to either side of the line along which it drives straight on [m].
    public double halfWidth() {
        return corners.stream().mapToDouble(c -> Math.abs(c.y())).max().orElseThrow();
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
