package rsal.agents.formation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// The way of a formation: where its frame is after each bit of the way, how far beside it the formation goes there so
/// that it has room, and whether it has. Where it has none it is a column on the way itself.
///
/// @param mapFromPath every [#STEP] from the way's beginning, looking where it leads about there
/// @param asides to the left [m], in the same order
/// @param fits the same
record FormationCorridor(List<Pose2d> mapFromPath, List<Double> asides, List<Boolean> fits) {
    static final double STEP = 0.5; // m

    private static final double AHEAD = 2; // m that must fit before it narrows; twice that before it widens
    private static final double WORTH = 5; // m; wide for less is not worth it
    private static final int SHIFT = 1; // lanes per step at most
    private static final double NONE = 1e6; // dearer than all that is possible

    FormationCorridor {
        mapFromPath = List.copyOf(mapFromPath);
        asides = List.copyOf(asides);
        fits = List.copyOf(fits);
    }

    /// How far to the left one of several lanes is [m].
    static double aside(int number, int lanes) {
        return (number - lanes / 2) * STEP;
    }

    /// Keeps as near to the way as there is room, without swerving.
    ///
    /// @param hasRoom for each pose of the way, whether there is room in each of its lanes
    static FormationCorridor of(List<Pose2d> mapFromPath, boolean[][] hasRoom) {
        int[] lanes = lanes(hasRoom);
        var asides = new ArrayList<Double>();
        var room = new ArrayList<Boolean>();
        for (int i = 0; i < hasRoom.length; i++) {
            asides.add(aside(lanes[i], hasRoom[i].length));
            room.add(hasRoom[i][lanes[i]]);
        }
        return new FormationCorridor(mapFromPath, asides, lasting(room));
    }

    /// The lanes in which most of the way has room and which are least aside, by dynamic programming (R. Bellman,
    /// 1957).
    private static int[] lanes(boolean[][] hasRoom) {
        int count = hasRoom[0].length;
        var cost = new double[hasRoom.length][count];
        var from = new int[hasRoom.length][count];
        for (int i = 0; i < cost.length; i++) {
            for (int lane = 0; lane < count; lane++) {
                double own = Math.abs(aside(lane, count)) + (hasRoom[i][lane] ? 0 : NONE / cost.length);
                double best = i == 0 ? 0 : Double.POSITIVE_INFINITY;
                for (int before = Math.max(0, lane - SHIFT);
                        i > 0 && before <= Math.min(count - 1, lane + SHIFT);
                        before++) {
                    double through = cost[i - 1][before] + Math.abs(before - lane);
                    if (through < best) {
                        best = through;
                        from[i][lane] = before;
                    }
                }
                cost[i][lane] = own + best;
            }
        }
        var lanes = new int[cost.length];
        int last = cost.length - 1;
        for (int lane = 1; lane < count; lane++) {
            lanes[last] = cost[last][lane] < cost[last][lanes[last]] ? lane : lanes[last];
        }
        for (int i = last; i > 0; i--) {
            lanes[i - 1] = from[i][lanes[i]];
        }
        return lanes;
    }

    /// Poses along a way, which look where the way leads about there.
    ///
    /// @param points of the way
    /// @param reach how far before and after a place the way counts for where the formation looks [m]
    static List<Pose2d> along(List<Point2d> points, double reach) {
        List<Point2d> even = even(points);
        int window = Math.max(1, (int) Math.round(reach / STEP));
        var poses = new ArrayList<Pose2d>();
        for (int i = 0; i < even.size(); i++) {
            Point2d from = even.get(Math.max(0, i - window));
            Point2d to = even.get(Math.min(even.size() - 1, i + window));
            double heading = Math.atan2(to.y() - from.y(), to.x() - from.x());
            poses.add(new Pose2d(even.get(i).x(), even.get(i).y(), heading));
        }
        return poses;
    }

    private static List<Point2d> even(List<Point2d> points) {
        var even = new ArrayList<Point2d>();
        even.add(points.getFirst());
        double left = STEP; // until the next
        for (int i = 1; i < points.size(); i++) {
            Point2d from = points.get(i - 1);
            Point2d to = points.get(i);
            double length = from.distanceTo(to);
            double at = left;
            for (; at <= length; at += STEP) {
                double share = at / length;
                even.add(new Point2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y())));
            }
            left = at - length;
        }
        if (even.getLast().distanceTo(points.getLast()) > STEP / 10) {
            even.add(points.getLast());
        }
        return even;
    }

    /// Without what is too short. A formation that arrives takes its shape, be it only there.
    private static List<Boolean> lasting(List<Boolean> room) {
        int count = room.size();
        var lasting = room.toArray(Boolean[]::new);
        int begin = 0;
        for (int i = 1; i <= count; i++) {
            if (i < count && lasting[i].equals(lasting[begin])) {
                continue;
            }
            if (i < count && lasting[begin] && (i - begin) * STEP < WORTH) {
                Arrays.fill(lasting, begin, i, false);
            }
            begin = i;
        }
        return List.of(lasting);
    }

    /// [m]
    double length() {
        return (mapFromPath.size() - 1) * STEP;
    }

    /// A place on the way.
    ///
    /// @param at since the beginning [m]; before it the way goes straight on
    Pose2d onWay(double at) {
        if (at <= 0) {
            return mapFromPath.getFirst().compose(new Pose2d(at, 0, 0));
        }
        int before = (int) (at / STEP);
        if (before >= mapFromPath.size() - 1) {
            return mapFromPath.getLast();
        }
        return mapFromPath.get(before).towards(mapFromPath.get(before + 1), at / STEP - before);
    }

    /// Where the formation's frame is, beside the way.
    Pose2d beside(double at) {
        double index = Math.clamp(at / STEP, 0, asides.size() - 1.0);
        int before = Math.min((int) index, asides.size() - 2);
        double share = index - before;
        double aside = (1 - share) * asides.get(before) + share * asides.get(before + 1);
        return onWay(at).compose(new Pose2d(0, aside, 0));
    }

    /// Whether it has room here and a bit ahead.
    ///
    /// @param narrow whether it is a column now, which looks farther before it changes
    boolean fits(double at, boolean narrow) {
        int from = Math.clamp((int) (at / STEP), 0, fits.size() - 1);
        int to = Math.min(fits.size(), from + 1 + (int) ((narrow ? 2 : 1) * AHEAD / STEP));
        return !fits.subList(from, to).contains(false);
    }

    @Override
    public String toString() {
        long wide = fits.stream().filter(fit -> fit).count();
        return String.format(Locale.ROOT, "%.1f m, with room for %.1f m of it", length(), wide * STEP);
    }
}
