package rsal.data;

import java.util.List;
import java.util.stream.IntStream;

/// What a body looks like from above, in its own frame [m].
public sealed interface Shape {
    /// The smallest convex outline around it; a bit more for a disc.
    Footprint hull();

    /// An outline without crossings; dents are allowed.
    ///
    /// @param corners in order; kept counter-clockwise, whichever way they were given
    record Polygon(List<Point2d> corners) implements Shape {
        /// @throws IllegalArgumentException when it is not an outline, saying why
        public Polygon {
            corners = List.copyOf(corners);
            if (corners.size() < 3) {
                throw new IllegalArgumentException(
                        "An outline needs at least 3 corners, not %d.".formatted(corners.size()));
            }
            for (Point2d corner : corners) {
                if (!Double.isFinite(corner.x()) || !Double.isFinite(corner.y())) {
                    throw new IllegalArgumentException(
                            "Corner (%s, %s) is not finite.".formatted(corner.x(), corner.y()));
                }
            }
            if (corners.stream().distinct().count() < corners.size()) {
                throw new IllegalArgumentException("An outline passes each of its corners once.");
            }
            requireSimple(corners);
            if (Footprint.isFlat(corners)) {
                throw new IllegalArgumentException("An outline must enclose something; its corners are in a line.");
            }
            corners = Footprint.twiceArea(corners) > 0 ? corners : corners.reversed();
        }

        /// What it encloses [m²].
        public double area() {
            return Footprint.twiceArea(corners) / 2;
        }

        public static Polygon of(Footprint footprint) {
            return new Polygon(footprint.corners());
        }

        @Override
        public Footprint hull() {
            return Footprint.around(corners);
        }

        private static void requireSimple(List<Point2d> corners) {
            int n = corners.size();
            for (int i = 0; i < n; i++) {
                for (int j = i + 1; j < n; j++) {
                    Point2d a = corners.get(i);
                    Point2d b = corners.get((i + 1) % n);
                    Point2d c = corners.get(j);
                    Point2d d = corners.get((j + 1) % n);
                    boolean neighbours = j == i + 1 || (j + 1) % n == i;
                    if (!neighbours && meet(a, b, c, d)) {
                        throw new IllegalArgumentException(
                                "The edge from (%s, %s) to (%s, %s) meets the one from (%s, %s) to (%s, %s)."
                                        .formatted(a.x(), a.y(), b.x(), b.y(), c.x(), c.y(), d.x(), d.y()));
                    }
                }
            }
        }

        private static boolean meet(Point2d a, Point2d b, Point2d c, Point2d d) {
            double abc = Math.signum(Footprint.turn(a, b, c));
            double abd = Math.signum(Footprint.turn(a, b, d));
            double cda = Math.signum(Footprint.turn(c, d, a));
            double cdb = Math.signum(Footprint.turn(c, d, b));
            return (abc * abd < 0 && cda * cdb < 0)
                    || (abc == 0 && between(a, b, c))
                    || (abd == 0 && between(a, b, d))
                    || (cda == 0 && between(c, d, a))
                    || (cdb == 0 && between(c, d, b));
        }

        private static boolean between(Point2d from, Point2d to, Point2d inLine) {
            return Math.min(from.x(), to.x()) <= inLine.x()
                    && inLine.x() <= Math.max(from.x(), to.x())
                    && Math.min(from.y(), to.y()) <= inLine.y()
                    && inLine.y() <= Math.max(from.y(), to.y());
        }
    }

    record Disc(Point2d center, double radius) implements Shape {
        private static final int CORNERS = 24;

        public Disc {
            if (!(radius > 0 && Double.isFinite(radius) && Double.isFinite(center.x() + center.y()))) {
                throw new IllegalArgumentException(
                        "A disc's radius '%s' must be positive and finite, its center (%s, %s) finite."
                                .formatted(radius, center.x(), center.y()));
            }
        }

        /// 24 corners around it, at most 0.9 % of the radius outside of it.
        @Override
        public Footprint hull() {
            double around = radius / Math.cos(Math.PI / CORNERS);
            return new Footprint(IntStream.range(0, CORNERS)
                    .mapToObj(i -> Pose2d.polar(around, 2 * Math.PI * i / CORNERS))
                    .map(corner -> new Point2d(center.x() + corner.x(), center.y() + corner.y()))
                    .toList());
        }
    }
}
