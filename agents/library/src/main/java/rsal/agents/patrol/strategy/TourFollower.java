package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiFunction;
import org.jspecify.annotations.Nullable;
import rsal.agent.team.Assignment;

/// Follows one tour of a plan that all members of the team find alike. Members take their starts on the tours
/// so that the longest path to one is short, and report which start they have taken; when two have taken the
/// same one, the one with the lower number keeps it. When the number of members changes, all plan again. One that
/// has another plan, as its planner failed when it began, counts as one without a start.
final class TourFollower implements PatrolStrategy {
    private static final double JUST_VISITED = 0.15; // of the time between two visits
    private static final int NOTE = 3; // numbers
    private static final double LATE = 1.1; // times what is planned, and what own places then have
    private static final double SHORT = 0.4; // of a round
    private static final double SOON = 10; // s

    private final BiFunction<PatrolGraph, Integer, PatrolPlan> planner;
    private final double spacing;
    private final boolean helps;
    private final Map<Integer, PatrolPlan> plans = new HashMap<>(); // for the graph, by number of members
    private @Nullable PatrolGraph graph;
    private @Nullable PatrolPlan plan;
    private List<int[]> slots = List.of();
    private int members;
    private int key; // of the plan
    private int slot = PatrolView.NONE;
    private int position = PatrolView.NONE;
    private int direction = 1;
    private boolean helping;

    /// @param planner of the places and the number of members
    /// @param spacing on a shared tour, the share of the time between two visits before which it does not
    /// follow; 0 when it never waits
    /// @param helps whether it visits a place of another tour that is overdue, when its own places can wait
    TourFollower(BiFunction<PatrolGraph, Integer, PatrolPlan> planner, double spacing, boolean helps) {
        this.planner = planner;
        this.spacing = spacing;
        this.helps = helps;
    }

    /// The plan's key, which start it has taken, and to which position on its tour it goes.
    @Override
    public int[] note() {
        return new int[] {key, slot, position};
    }

    @Override
    public int next(PatrolView view) {
        PatrolPlan tours = plan;
        if (tours == null || members != view.members()) {
            tours = planned(view);
            plan = tours;
            slots = tours.slots();
            members = view.members();
            key = tours.key();
            slot = PatrolView.NONE;
        }
        if (slot == PatrolView.NONE || isTaken(view, slot, view.self())) {
            slot = free(view, tours);
            position = PatrolView.NONE;
        }
        int tour = slots.get(slot)[0];
        int[] places = tours.places(tour);
        if (position == PatrolView.NONE) {
            enter(view, tours, tour);
            return places[position];
        }
        int following = following(view, tours, tour);
        int next = places[following];
        if (spacing > 0 && tours.robots(tour) > 1 && lag(view, tours, tour) < spacing * tours.gap(tour)) {
            return view.here();
        }
        if (helps && !helping) {
            int late = late(view, tours, tour, following);
            if (late != PatrolView.NONE) {
                helping = true;
                return late;
            }
        }
        helping = false;
        position = following;
        return next;
    }

    /// As before when as many members were there before.
    private PatrolPlan planned(PatrolView view) {
        if (graph != view.graph()) {
            graph = view.graph();
            plans.clear();
        }
        return plans.computeIfAbsent(view.members(), count -> planner.apply(view.graph(), count));
    }

    /// How far the robot is behind the next one on its tour [s].
    private double lag(PatrolView view, PatrolPlan tours, int tour) {
        int[] places = tours.places(tour);
        double round = Tours.time(view.graph(), places);
        double least = round;
        for (int member = 0; member < members; member++) {
            int[] note = view.note(member);
            boolean sharesIt = member != view.self() && hasAny(view, member) && slots.get(note[1])[0] == tour;
            if (sharesIt && note[2] >= 0 && note[2] < places.length) {
                double rest = Math.max(0, view.arrival(member) - view.now());
                double ahead = 0;
                for (int i = position; i != note[2]; i = (i + 1) % places.length) {
                    ahead += view.graph().time(places[i], places[(i + 1) % places.length]);
                }
                double lag = ahead - (Double.isFinite(rest) ? rest : 0);
                least = Math.min(least, lag <= 0 && member > view.self() ? lag + round : lag);
            }
        }
        return least;
    }

    /// The next position on the tour, without those that somebody has just passed.
    private int following(PatrolView view, PatrolPlan tours, int tour) {
        int[] places = tours.places(tour);
        int following = position;
        for (int i = 0; i < places.length; i++) {
            following = Math.floorMod(following + direction, places.length);
            if (view.idle(places[following]) > JUST_VISITED * tours.gap(tour)) {
                return following;
            }
        }
        return Math.floorMod(position + direction, places.length);
    }

    /// On a shared tour it begins at its start. On a tour of its own it begins at the nearest place; one that
    /// helps begins where, and in the direction in which, places are idle for the shortest time when it gets to
    /// them.
    private void enter(PatrolView view, PatrolPlan tours, int tour) {
        int[] places = tours.places(tour);
        direction = 1;
        if (tours.robots(tour) > 1) {
            position = slots.get(slot)[1];
            return;
        }
        double least = Double.POSITIVE_INFINITY;
        position = 0;
        for (int start = 0; start < places.length; start++) {
            for (int way = 1; way >= (helps ? -1 : 1); way -= 2) {
                double cost = helps ? idleAtArrival(view, places, start, way) : view.lengthTo(places[start]);
                if (cost < least) {
                    least = cost;
                    position = start;
                    direction = way;
                }
            }
        }
    }

    /// Of the places on a tour that is entered somewhere: the largest time since a visit, plus half of the mean
    /// [s].
    private static double idleAtArrival(PatrolView view, int[] places, int start, int way) {
        double time = view.lengthTo(places[start]) / view.graph().speed();
        double most = 0;
        double sum = 0;
        for (int i = 0; i < places.length; i++) {
            int place = places[Math.floorMod(start + way * i, places.length)];
            if (i > 0) {
                time += view.graph().time(places[Math.floorMod(start + way * (i - 1), places.length)], place);
            }
            most = Math.max(most, view.idle(place) + time);
            sum += view.idle(place) + time;
        }
        return most + sum / places.length / 2;
    }

    /// Whether another one has the start, and keeps it.
    private boolean isTaken(PatrolView view, int start, int below) {
        for (int member = 0; member < below; member++) {
            if (member != view.self() && hasTaken(view, member, start)) {
                return true;
            }
        }
        return false;
    }

    private boolean hasTaken(PatrolView view, int member, int start) {
        int[] note = view.note(member);
        return note.length == NOTE && note[0] == key && note[1] == start;
    }

    /// A start that nobody has taken, such that the longest of the paths that the members have to the free ones
    /// is short.
    private int free(PatrolView view, PatrolPlan tours) {
        var open = new ArrayList<Integer>();
        for (int start = 0; start < slots.size(); start++) {
            if (!isTaken(view, start, members)) {
                open.add(start);
            }
        }
        var costs = new TreeMap<String, double[]>();
        for (int member = 0; member < members; member++) {
            if (member == view.self() || !hasAny(view, member)) {
                var row = new double[open.size()];
                for (int i = 0; i < row.length; i++) {
                    row[i] = pathTo(view, tours, member, slots.get(open.get(i)));
                }
                costs.put(name(member), row);
            }
        }
        Integer chosen = open.isEmpty() ? null : Assignment.even(costs).get(name(view.self()));
        return chosen == null ? view.self() % slots.size() : open.get(chosen);
    }

    private boolean hasAny(PatrolView view, int member) {
        int[] note = view.note(member);
        return note.length == NOTE && note[0] == key && note[1] >= 0 && note[1] < slots.size();
    }

    private static String name(int member) {
        return "%04d".formatted(member);
    }

    /// How far a member has to drive to a start [m]; on a tour of its own, to the nearest of its places.
    private static double pathTo(PatrolView view, PatrolPlan tours, int member, int[] start) {
        int[] places = tours.places(start[0]);
        if (tours.robots(start[0]) > 1) {
            return path(view, member, places[start[1]]);
        }
        double least = Double.POSITIVE_INFINITY;
        for (int place : places) {
            least = Math.min(least, path(view, member, place));
        }
        return least;
    }

    private static double path(PatrolView view, int member, int place) {
        if (member == view.self()) {
            return view.lengthTo(place);
        }
        int from = view.next(member) == PatrolView.NONE ? view.at(member) : view.next(member);
        return from == PatrolView.NONE ? 0 : view.graph().length(from, place);
    }

    /// The place of another tour that will have been idle for longest when the robot gets there: for longer
    /// than planned, and for longer than all places of the own tour when they are visited after that, which is
    /// in time. None when the detour is long, or another one gets there soon.
    private int late(PatrolView view, PatrolPlan tours, int tour, int following) {
        double speed = view.graph().speed();
        double stop = view.graph().stop();
        int next = tours.places(tour)[following];
        int best = PatrolView.NONE;
        double most = 0;
        for (int place = 0; place < view.graph().size(); place++) {
            double there = view.lengthTo(place) / speed + stop;
            if (tours.tourOf(place) == tour || soonest(view, place) < view.now() + there + SOON) {
                continue;
            }
            double idle = view.idle(place) + there;
            double planned = LATE * tours.worst();
            double detour = there + view.graph().time(place, next) - view.lengthTo(next) / speed;
            boolean isLate = idle > planned && detour <= SHORT * tours.gap(tour);
            if (isLate && idle > most) {
                double after = idleAfter(view, tours.places(tour), following, place, there);
                if (after <= planned && idle > LATE * after) {
                    most = idle;
                    best = place;
                }
            }
        }
        return best;
    }

    /// When another one will be at a place, as far as is known; +∞ when nobody goes there.
    private static double soonest(PatrolView view, int place) {
        double soonest = Double.POSITIVE_INFINITY;
        for (int member = 0; member < view.members(); member++) {
            if (member != view.self() && view.next(member) == place) {
                soonest = Math.min(soonest, view.arrival(member));
            }
        }
        return soonest;
    }

    /// The largest time since a visit of a place of the own tour, when the robot goes on with it from elsewhere
    /// [s].
    private double idleAfter(PatrolView view, int[] places, int following, int from, double departure) {
        double time = departure;
        double most = 0;
        int last = from;
        for (int i = 0; i < places.length; i++) {
            int place = places[Math.floorMod(following + direction * i, places.length)];
            time += view.graph().time(last, place);
            most = Math.max(most, view.idle(place) + time);
            last = place;
        }
        return most;
    }
}
