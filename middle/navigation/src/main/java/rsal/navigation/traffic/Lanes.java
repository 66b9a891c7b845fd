package rsal.navigation.traffic;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.passage.Passages;

/// Moves a path into the right half of corridors in which two robots can pass each other, so that those who come the
/// other way never meet in one lane. In what is narrower or wider, the path stays; short places without walls at the
/// sides, such as junctions, are crossed in line. Immutable.
public final class Lanes {
    private static final double STEP = 0.2; // m between points of the path
    private static final double WIDEST = 3.2; // m; in wider places robots drive around each other
    private static final double TO_WALL = 0.12; // m
    private static final double ROOM = 0.08; // m to walls, least
    private static final int SPAN = 2; // points to each side, for the direction of the path
    private static final int LONGEST_GAP = 25; // points
    private static final int SHORTEST = 16; // points with walls at both sides
    private static final int SMOOTH = 3; // points to each side
    private static final int KEPT = 6; // points before and behind a corridor that are in its lane
    private static final int FADE = 5; // points in which a path changes its lane, and at its ends

    private final DistanceField toNotFree;
    private final double radius;

    /// @param radius of the circle that the robot turns in [m]
    public Lanes(DistanceField toNotFree, double radius) {
        this.toNotFree = toNotFree;
        this.radius = radius;
    }

    /// The same path in its lane, from the same start to the same end.
    ///
    /// @param path corners, map frame
    public List<Point2d> right(List<Point2d> path) {
        List<Point2d> points = resampled(path);
        int count = points.size();
        if (count < 2 * FADE) {
            return path;
        }
        var sideways = new double[count];
        boolean any = false;
        for (int i = 0; i < count; i++) {
            sideways[i] = sideways(points, i);
            any |= !Double.isNaN(sideways[i]) && sideways[i] != 0;
        }
        if (!any) {
            return path;
        }
        dropShort(sideways);
        fill(sideways);
        return shifted(points, smoothed(sideways));
    }

    /// How far a point is to be moved to the right [m]; not a number where nothing says so.
    private double sideways(List<Point2d> points, int i) {
        double direction = direction(points, i);
        Point2d place = points.get(i);
        double right = toNotFree.castRay(place.x(), place.y(), direction - Math.PI / 2, WIDEST);
        double left = toNotFree.castRay(place.x(), place.y(), direction + Math.PI / 2, WIDEST);
        double width = left + right;
        if (width >= WIDEST) {
            return Double.NaN;
        }
        return width < 2 * Passages.halfWidth(radius) ? 0 : right - Math.max(width / 4, radius + TO_WALL);
    }

    private static double direction(List<Point2d> points, int i) {
        Point2d from = points.get(Math.max(0, i - SPAN));
        Point2d to = points.get(Math.min(points.size() - 1, i + SPAN));
        return Math.atan2(to.y() - from.y(), to.x() - from.x());
    }

    /// A room is no corridor, though it is no wider: where lanes would be short, they are none.
    private static void dropShort(double[] sideways) {
        int from = 0;
        int known = 0;
        int last = -1;
        for (int i = 0; i <= sideways.length; i++) {
            boolean isLane = i < sideways.length && !Double.isNaN(sideways[i]) && sideways[i] != 0;
            boolean isNarrow = i < sideways.length && sideways[i] == 0;
            if (i == sideways.length || isNarrow || (isLane && last >= 0 && i - last > LONGEST_GAP)) {
                for (int k = from; k < i && known < SHORTEST; k++) {
                    sideways[k] = sideways[k] == 0 ? 0 : Double.NaN;
                }
                from = i;
                known = 0;
                last = -1;
            }
            if (isLane) {
                known++;
                last = i;
            }
        }
    }

    /// Between two known values in a line, if that is not far; else each goes on for a while, so that robots are in
    /// their lane before a corridor begins.
    private static void fill(double[] sideways) {
        int last = -1;
        for (int i = 0; i <= sideways.length; i++) {
            if (i < sideways.length && Double.isNaN(sideways[i])) {
                continue;
            }
            double before = last < 0 ? 0 : sideways[last];
            double after = i == sideways.length ? 0 : sideways[i];
            boolean joins = last >= 0 && i < sideways.length && i - last <= LONGEST_GAP && before != 0 && after != 0;
            for (int k = last + 1; k < i; k++) {
                double share = (double) (k - last) / (i - last);
                sideways[k] = joins
                        ? before + share * (after - before)
                        : before * kept(k - last) + after * kept(i - k) * (1 - kept(k - last));
            }
            last = i;
        }
    }

    /// How much of a lane is kept at some points from the corridor.
    private static double kept(int points) {
        return Math.clamp((double) (KEPT + FADE - points) / FADE, 0, 1);
    }

    private static double[] smoothed(double[] sideways) {
        var smoothed = new double[sideways.length];
        for (int i = 0; i < sideways.length; i++) {
            double sum = 0;
            int count = 0;
            for (int k = Math.max(0, i - SMOOTH); k <= Math.min(sideways.length - 1, i + SMOOTH); k++) {
                sum += sideways[k];
                count++;
            }
            int toEnd = Math.min(i, sideways.length - 1 - i);
            smoothed[i] = sum / count * Math.min(1, (double) toEnd / FADE);
        }
        return smoothed;
    }

    private List<Point2d> shifted(List<Point2d> points, double[] sideways) {
        var lane = new ArrayList<Point2d>();
        lane.add(points.getFirst());
        for (int i = 1; i < points.size() - 1; i++) {
            double direction = direction(points, i);
            Point2d place = moved(points.get(i), direction, sideways[i]);
            Point2d before = lane.getLast();
            double on = (place.x() - before.x()) * Math.cos(direction) + (place.y() - before.y()) * Math.sin(direction);
            if (on > STEP / 4) { // in a bend, points of the inner side would go back
                lane.add(place);
            }
        }
        lane.add(points.getLast());
        return lane;
    }

    private Point2d moved(Point2d place, double direction, double sideways) {
        for (int part = 4; part > 0; part--) {
            double by = sideways * part / 4;
            var there = new Point2d(place.x() + by * Math.sin(direction), place.y() - by * Math.cos(direction));
            if (toNotFree.at(there.x(), there.y()) >= radius + ROOM) {
                return there;
            }
        }
        return place;
    }

    private static List<Point2d> resampled(List<Point2d> path) {
        var points = new ArrayList<Point2d>();
        double length = 0;
        for (int i = 1; i < path.size(); i++) {
            length += path.get(i - 1).distanceTo(path.get(i));
        }
        int steps = Math.max(1, (int) Math.round(length / STEP));
        int leg = 1;
        double before = 0;
        for (int i = 0; i < steps; i++) {
            double at = length * i / steps;
            double whole = path.get(leg - 1).distanceTo(path.get(leg));
            while (leg < path.size() - 1 && before + whole < at) {
                before += whole;
                leg++;
                whole = path.get(leg - 1).distanceTo(path.get(leg));
            }
            double share = whole == 0 ? 0 : Math.clamp((at - before) / whole, 0, 1);
            Point2d from = path.get(leg - 1);
            Point2d to = path.get(leg);
            points.add(new Point2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y())));
        }
        points.add(path.getLast());
        return points;
    }
}
