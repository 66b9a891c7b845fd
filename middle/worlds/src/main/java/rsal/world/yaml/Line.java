package rsal.world.yaml;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Shape;

/// A wall along a line.
final class Line {
    private static final double THIN = 0.001; // of what has no thickness [m]
    private static final double SHARPEST = Math.toRadians(120); // turn that is mitred
    private static final double HOLLOW = 0.001; // how far a ring's corners are outside of its circle [m]
    private static final int MOST_CORNERS = 720; // of a ring

    private final List<Point2d> points;
    private final boolean closed;
    private final double half;
    private final List<Shape> shapes = new ArrayList<>();

    private Line(List<Point2d> points, boolean closed, double thickness) {
        this.points = points;
        this.closed = closed;
        this.half = Math.max(thickness, THIN) / 2;
    }

    /// @param points no two in succession alike
    /// @return pieces without gaps; corners are mitred, sharp ones round
    static List<Shape> shapes(List<Point2d> points, boolean closed, double thickness) {
        var line = new Line(points, closed && points.size() > 2, thickness);
        line.build();
        return line.shapes;
    }

    /// The points of a shape's border.
    static List<Point2d> border(Shape shape) {
        return switch (shape) {
            case Shape.Polygon polygon -> polygon.corners();
            case Shape.Disc disc -> {
                double r = disc.radius();
                int corners =
                        (int) Math.clamp(Math.ceil(Math.PI / Math.acos(Math.max(0, 1 - HOLLOW / r))), 12, MOST_CORNERS);
                var around = new ArrayList<Point2d>();
                for (int i = 0; i < corners; i++) {
                    double angle = 2 * Math.PI * i / corners;
                    around.add(new Point2d(
                            disc.center().x() + r * Math.cos(angle),
                            disc.center().y() + r * Math.sin(angle)));
                }
                yield around;
            }
        };
    }

    private void build() {
        int n = points.size();
        int segments = closed ? n : n - 1;
        for (int i = 0; i < segments; i++) {
            segment(i);
        }
        for (int i = closed ? 0 : 1; i < (closed ? n : n - 1); i++) {
            if (!mitred(i)) {
                shapes.add(new Shape.Disc(points.get(i), half));
            }
        }
    }

    private Point2d at(int i) {
        return points.get(Math.floorMod(i, points.size()));
    }

    private boolean hasCorner(int i) {
        return closed || (i > 0 && i < points.size() - 1);
    }

    private static double direction(Point2d from, Point2d to) {
        return Math.atan2(to.y() - from.y(), to.x() - from.x());
    }

    private double turn(int i) {
        return rsal.data.Angles.difference(direction(at(i - 1), at(i)), direction(at(i), at(i + 1)));
    }

    /// Whether the two segments at a corner end where their borders meet.
    private boolean mitred(int i) {
        if (!hasCorner(i)) {
            return false;
        }
        double turn = Math.abs(turn(i));
        double cut = half * Math.tan(turn / 2); // how far the inner borders are shorter
        double shortest = Math.min(at(i - 1).distanceTo(at(i)), at(i).distanceTo(at(i + 1)));
        return turn <= SHARPEST && 2 * cut < shortest;
    }

    private void segment(int i) {
        Point2d from = at(i);
        Point2d to = at(i + 1);
        double direction = direction(from, to);
        double begin = mitred(i) ? Math.tan(turn(i) / 2) : 0;
        double end = mitred(i + 1) ? Math.tan(turn(i + 1) / 2) : 0;
        shapes.add(new Shape.Polygon(List.of(
                beside(from, direction, -begin, -1),
                beside(to, direction, end, -1),
                beside(to, direction, -end, 1),
                beside(from, direction, begin, 1))));
    }

    /// @param along in halves of the thickness
    /// @param left the same
    private Point2d beside(Point2d point, double direction, double along, double left) {
        double cos = half * Math.cos(direction);
        double sin = half * Math.sin(direction);
        return new Point2d(
                point.x() + along * cos - left * sin, //
                point.y() + along * sin + left * cos);
    }
}
