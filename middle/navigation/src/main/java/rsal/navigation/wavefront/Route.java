package rsal.navigation.wavefront;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Path2d;
import rsal.data.Point2d;

/// A path under way: how far a robot has got on it and where it goes from there. It never goes back on it.
public final class Route {
    private static final double SEARCH = 3; // m; how far ahead on the path the robot may find itself

    private final List<Point2d> points;
    private final double[] before; // length of way up to each point
    private double done;
    private double offset;

    public Route(Path2d path) {
        if (path.points().size() < 2) {
            throw new IllegalArgumentException("A route needs a start and a goal, not %s.".formatted(path.points()));
        }
        this.points = path.points();
        this.before = new double[points.size()];
        for (int i = 1; i < before.length; i++) {
            before[i] = before[i - 1] + points.get(i - 1).distanceTo(points.get(i));
        }
    }

    /// The robot is here now: finds the nearest point of the path from where it was on.
    public void advance(Point2d position) {
        double from = done;
        offset = Double.POSITIVE_INFINITY;
        for (int leg = 1; leg < before.length && before[leg - 1] <= from + SEARCH; leg++) {
            if (before[leg] < from) {
                continue;
            }
            Point2d a = points.get(leg - 1);
            Point2d b = points.get(leg);
            double length = before[leg] - before[leg - 1];
            double along = length == 0
                    ? 0
                    : ((position.x() - a.x()) * (b.x() - a.x()) + (position.y() - a.y()) * (b.y() - a.y())) / length;
            double at = Math.max(from, before[leg - 1] + Math.clamp(along, 0, length));
            double distance = at(at).distanceTo(position);
            if (distance < offset) {
                offset = distance;
                done = at;
            }
        }
    }

    /// How far the robot is off the path [m].
    public double offset() {
        return offset;
    }

    /// Length of way left [m].
    public double remaining() {
        return before[before.length - 1] - done;
    }

    public Point2d end() {
        return points.getLast();
    }

    /// Where to head for: the farthest point at most `lookahead` [m] ahead to which the way is straight and
    /// passable.
    public Point2d target(Point2d position, CostMap map, double lookahead) {
        double far = Math.min(lookahead, remaining());
        for (double ahead = far; ahead > far / 8; ahead -= far / 8) {
            Point2d target = at(done + ahead);
            if (map.straightCost(position, target) < Double.POSITIVE_INFINITY) {
                return target;
            }
        }
        return at(done + far / 4); // off the passable: back to the path soon
    }

    /// The same way to another end, if it goes straight on from the old one.
    public Path2d extended(Point2d position, Point2d end) {
        var path = new ArrayList<>(left(position).points());
        path.add(end);
        return new Path2d(path);
    }

    /// The way left, from where the robot is.
    public Path2d left(Point2d position) {
        var left = new ArrayList<Point2d>();
        left.add(position);
        for (int i = 1; i < before.length; i++) {
            if (before[i] > done || i == before.length - 1) {
                left.add(points.get(i));
            }
        }
        return new Path2d(left);
    }

    /// The same, but from the robot to the path first, and then along it: what is left when the robot has left the path
    /// for a while.
    public Path2d leftAlong(Point2d position) {
        var left = new ArrayList<Point2d>();
        left.add(position);
        left.add(at(done));
        for (int i = 1; i < before.length; i++) {
            if (before[i] > done || i == before.length - 1) {
                left.add(points.get(i));
            }
        }
        return new Path2d(left);
    }

    private Point2d at(double way) {
        int leg = 1;
        while (leg < before.length - 1 && before[leg] < way) {
            leg++;
        }
        Point2d a = points.get(leg - 1);
        Point2d b = points.get(leg);
        double length = before[leg] - before[leg - 1];
        double share = length == 0 ? 0 : Math.clamp((way - before[leg - 1]) / length, 0, 1);
        return new Point2d(a.x() + share * (b.x() - a.x()), a.y() + share * (b.y() - a.y()));
    }
}
