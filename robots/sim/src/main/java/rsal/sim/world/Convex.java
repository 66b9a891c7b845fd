package rsal.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;

/// Takes outlines apart into small convex ones that together cover the same.
final class Convex {
    private static final double LARGEST = 2; // [m], along an axis
    private static final double NOTHING = 1e-12; // [m²]; rounding can leave parts of that size

    private Convex() {}

    /// @param corners of an outline without crossings, counter-clockwise
    static List<List<Point2d>> small(List<Point2d> corners) {
        var small = new ArrayList<List<Point2d>>();
        parts(corners).forEach(part -> cut(part, small));
        return small;
    }

    /// Convex parts: triangles by clipping one ear after the other (Meisters, Polygons Have Ears, 1975), then
    /// joined along their diagonals as long as they stay convex (Hertel and Mehlhorn, Fast Triangulation of Simple
    /// Polygons, 1983).
    static List<List<Point2d>> parts(List<Point2d> corners) {
        var parts = new ArrayList<List<Point2d>>();
        var left = new ArrayList<>(corners);
        while (left.size() > 2) {
            int ear = ear(left);
            int size = left.size();
            var triangle = List.of(left.get((ear + size - 1) % size), left.get(ear), left.get((ear + 1) % size));
            if (area(triangle) > NOTHING) {
                parts.add(triangle);
            }
            left.remove(ear);
        }
        join(parts);
        return parts;
    }

    /// A corner whose triangle with its neighbors holds no other; one in a line with them is as good.
    private static int ear(List<Point2d> corners) {
        int size = corners.size();
        int flattest = 0;
        for (int i = 0; i < size; i++) {
            Point2d before = corners.get((i + size - 1) % size);
            Point2d corner = corners.get(i);
            Point2d after = corners.get((i + 1) % size);
            double turn = turn(before, corner, after);
            if (turn == 0 || (turn > 0 && isEmpty(corners, before, corner, after))) {
                return i;
            }
            flattest = turn > 0 ? i : flattest; // rounding alone can leave us without an ear
        }
        return flattest;
    }

    private static boolean isEmpty(List<Point2d> corners, Point2d a, Point2d b, Point2d c) {
        for (Point2d point : corners) {
            boolean own = point.equals(a) || point.equals(b) || point.equals(c);
            if (!own && turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0) {
                return false;
            }
        }
        return true;
    }

    private static void join(List<List<Point2d>> parts) {
        for (int i = 0; i < parts.size(); i++) {
            for (int j = i + 1; j < parts.size(); j++) {
                Optional<List<Point2d>> joint = joint(parts.get(i), parts.get(j));
                if (joint.isPresent()) {
                    parts.set(i, joint.get());
                    parts.remove(j);
                    j = i; // what is larger now may join another
                }
            }
        }
    }

    /// Two parts as one, if they share an edge and are convex together.
    private static Optional<List<Point2d>> joint(List<Point2d> one, List<Point2d> other) {
        for (int i = 0; i < one.size(); i++) {
            int j = other.indexOf(at(one, i + 1));
            if (j >= 0 && at(other, j + 1).equals(one.get(i))) {
                boolean convexBefore = turn(at(one, i - 1), one.get(i), at(other, j + 2)) >= 0;
                boolean convexAfter = turn(at(other, j - 1), other.get(j), at(one, i + 2)) >= 0;
                if (convexBefore && convexAfter) {
                    var joint = new ArrayList<Point2d>();
                    for (int k = 1; k <= one.size(); k++) {
                        joint.add(at(one, i + k));
                    }
                    for (int k = 2; k < other.size(); k++) {
                        joint.add(at(other, j + k));
                    }
                    return Optional.of(joint);
                }
            }
        }
        return Optional.empty();
    }

    /// The corner at an index that may go round.
    private static Point2d at(List<Point2d> corners, int index) {
        return corners.get(Math.floorMod(index, corners.size()));
    }

    private static void cut(List<Point2d> part, List<List<Point2d>> small) {
        double left = part.stream().mapToDouble(Point2d::x).min().orElseThrow();
        double right = part.stream().mapToDouble(Point2d::x).max().orElseThrow();
        double bottom = part.stream().mapToDouble(Point2d::y).min().orElseThrow();
        double top = part.stream().mapToDouble(Point2d::y).max().orElseThrow();
        if (Math.max(right - left, top - bottom) <= LARGEST) {
            small.add(part);
            return;
        }
        boolean across = right - left >= top - bottom;
        double border = across ? (left + right) / 2 : (bottom + top) / 2;
        var before = new ArrayList<Point2d>();
        var after = new ArrayList<Point2d>();
        for (int i = 0; i < part.size(); i++) {
            Point2d from = part.get(i);
            Point2d to = at(part, i + 1);
            double fromSide = (across ? from.x() : from.y()) - border;
            double toSide = (across ? to.x() : to.y()) - border;
            if (fromSide <= 0) {
                before.add(from);
            }
            if (fromSide >= 0) {
                after.add(from);
            }
            if (fromSide * toSide < 0) {
                double along = fromSide / (fromSide - toSide);
                var crossing = across
                        ? new Point2d(border, from.y() + along * (to.y() - from.y()))
                        : new Point2d(from.x() + along * (to.x() - from.x()), border);
                before.add(crossing);
                after.add(crossing);
            }
        }
        cut(before, small);
        cut(after, small);
    }

    private static double area(List<Point2d> corners) {
        double twice = 0;
        for (int i = 1; i < corners.size() - 1; i++) {
            twice += turn(corners.getFirst(), corners.get(i), corners.get(i + 1));
        }
        return twice / 2;
    }

    /// Twice the area of a triangle; positive when it is counter-clockwise.
    private static double turn(Point2d a, Point2d b, Point2d c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    }
}
