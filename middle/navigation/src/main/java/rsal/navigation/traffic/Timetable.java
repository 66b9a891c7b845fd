package rsal.navigation.traffic;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import rsal.data.Point2d;

/// When each robot of a team goes through the passages on its path, such that none meets another. Immutable.
///
/// Prioritized planning (Erdmann and Lozano-Pérez 1987; van den Berg and Overmars 2005, "Prioritized motion planning
/// for
/// multiple robots"): one robot after the other takes the earliest safe intervals that those before it leave (Phillips
/// and Likhachev 2011, "SIPP"). As the path is given and a robot may wait before each passage, there is no more
/// to search for one robot. Of up to five robots all orders are tried, of more those that move one robot to another
/// place in the order, as long as the sum of arrival times becomes less (hill climbing).
final class Timetable {
    private static final double HEADWAY = 3; // s between two robots in the same direction
    private static final double MARGIN = 1; // s that a passage stays occupied, as robots are late
    private static final double FAIR = 30; // s of waiting by which a robot counts once more
    private static final int FEW = 5; // robots, 120 orders
    private static final int MOST_ORDERS = 400;
    private static final double SAME = 1e-6; // s

    private final List<Entry> entries;
    private final double cost;

    /// A robot, and what it has to drive.
    ///
    /// @param id of the robot
    /// @param speed [m/s], above 0
    /// @param left length of its path [m]
    /// @param waited for how long it has waited [s]
    /// @param isCommitted whether it has its first passages, or may enter them
    /// @param legs in the order of its path
    record Trip(String id, double speed, double left, double waited, boolean isCommitted, List<Leg> legs) {
        Trip {
            legs = List.copyOf(legs);
        }
    }

    /// Passages which a robot has together.
    ///
    /// @param passages their indices
    /// @param entry gate through which it comes, which is its direction, too
    /// @param from length of path before them [m]
    /// @param to length of path to their end [m]
    record Leg(List<Integer> passages, Point2d entry, double from, double to) {
        Leg {
            passages = List.copyOf(passages);
        }

        /// Whether two robots would meet in it.
        boolean isAgainst(Leg other) {
            return sharesPassage(other) && !GateNeighbors.isSame(entry, other.entry);
        }

        private boolean sharesPassage(Leg other) {
            return passages.stream().anyMatch(other.passages::contains);
        }
    }

    /// One robot's time in passages, from now on.
    ///
    /// @param start when it enters [s]
    /// @param end when it is out [s]
    record Entry(String id, Leg leg, double start, double end) {}

    private Timetable(List<Entry> entries, double cost) {
        this.entries = List.copyOf(entries);
        this.cost = cost;
    }

    /// Plans the trips of all. Those that are committed go first.
    static Timetable of(List<Trip> trips) {
        List<Trip> order = new ArrayList<>(trips);
        order.sort(Comparator.comparing((Trip trip) -> !trip.isCommitted)
                .thenComparing(Comparator.comparingDouble((Trip trip) -> -trip.waited))
                .thenComparing(Trip::id));
        int fixed = (int) order.stream().filter(Trip::isCommitted).count();
        return order.size() - fixed <= FEW ? bestFrom(order, fixed) : climb(order, fixed);
    }

    /// The best of all orders of those from a place on.
    private static Timetable bestFrom(List<Trip> order, int place) {
        if (place >= order.size() - 1) {
            return inOrder(order);
        }
        Timetable best = bestFrom(order, place + 1);
        for (int next = place + 1; next < order.size(); next++) {
            var other = new ArrayList<Trip>(order);
            other.add(place, other.remove(next));
            Timetable table = bestFrom(other, place + 1);
            best = table.cost < best.cost - SAME ? table : best;
        }
        return best;
    }

    private static Timetable climb(List<Trip> first, int fixed) {
        List<Trip> order = first;
        Timetable best = inOrder(order);
        int tried = 1;
        boolean improves = true;
        while (improves && tried < MOST_ORDERS) {
            improves = false;
            for (int from = fixed; from < order.size() && tried < MOST_ORDERS; from++) {
                for (int to = fixed; to < order.size() && tried < MOST_ORDERS; to++) {
                    var other = new ArrayList<Trip>(order);
                    other.add(to, other.remove(from));
                    Timetable table = inOrder(other);
                    tried++;
                    if (table.cost < best.cost - SAME) {
                        best = table;
                        order = other;
                        improves = true;
                    }
                }
            }
        }
        return best;
    }

    static Timetable inOrder(List<Trip> order) {
        var entries = new ArrayList<Entry>();
        double cost = 0;
        for (Trip trip : order) {
            double time = 0;
            double way = 0;
            for (Leg leg : trip.legs) {
                time += Math.max(0, leg.from - way) / trip.speed;
                double duration = (leg.to - Math.max(way, leg.from)) / trip.speed + MARGIN;
                boolean isNow = trip.isCommitted && leg.equals(trip.legs.getFirst());
                double start = isNow ? time : earliest(entries, leg, time, duration);
                entries.add(new Entry(trip.id, leg, isNow ? 0 : start, start + duration));
                time = start + duration;
                way = leg.to;
            }
            time += Math.max(0, trip.left - way) / trip.speed;
            cost += (1 + trip.waited / FAIR) * time;
        }
        return new Timetable(entries, cost);
    }

    /// The first time from which on a leg is free for so long.
    private static double earliest(List<Entry> taken, Leg leg, double from, double duration) {
        double start = from;
        boolean moved = true;
        while (moved) {
            moved = false;
            for (Entry other : taken) {
                double free = freeAfter(other, leg, start, duration);
                if (free > start) {
                    start = free;
                    moved = true;
                }
            }
        }
        return start;
    }

    /// The time itself if another robot is not in the way then, else the first time after it.
    private static double freeAfter(Entry other, Leg leg, double start, double duration) {
        if (!leg.sharesPassage(other.leg) || start >= other.end || start + duration <= other.start) {
            return start;
        }
        if (leg.isAgainst(other.leg)) {
            return other.end;
        }
        return Math.max(other.start + HEADWAY, other.end + HEADWAY - duration); // nobody overtakes inside
    }

    /// All, in no special order.
    List<Entry> entries() {
        return entries;
    }

    /// Sum of all arrival times from now on [s], of which those that have waited count more.
    double cost() {
        return cost;
    }
}
