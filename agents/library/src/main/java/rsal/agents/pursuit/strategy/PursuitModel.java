package rsal.agents.pursuit.strategy;

import java.util.Arrays;

/// What hunters leave to a prey on the places of a floor, and where it runs to. All move along shortest paths at
/// constant speeds, and turn in no time.
///
/// The prey flees by TrailMax (C. Moldenhauer and N. R. Sturtevant, "Evaluating strategies for running from the cops",
/// IJCAI 2009): of the places that it reaches before any hunter, on paths of such places, it runs to the one that
/// hunters
/// reach last. Where no other place is left, it runs from the nearest hunter.
final class PursuitModel {
    /// Of a hunter that chases.
    static final int CHASE = FloorGraph.NONE;

    private static final double STEP = 1.0; // s
    private static final double FOR_A_PLACE = 0.02; // s
    private static final double FOR_A_METER = 0.02; // s
    private static final double CAUGHT = 1000; // s, more than a prey ever has left
    private static final double MARGIN = 0.5; // s by which the prey has to be sooner

    private final FloorGraph floor;
    private final double hunterSpeed;
    private final double preySpeed;
    private final double catchDistance;
    private final double[] arrivals; // of hunters [s], by place, for one decision
    private final double[] times; // of the prey [s]
    private final int[] previous;
    private final int[] queue;
    private final boolean[] waiting;

    // one hunt
    private int[] next = {}; // places that hunters drive to now
    private double[] left = {}; // m to there
    private int[] goals = {};
    private int prey; // its place
    private int safe; // places, at the prey's last decision

    PursuitModel(FloorGraph floor, double hunterSpeed, double preySpeed, double catchDistance) {
        this.floor = floor;
        this.hunterSpeed = hunterSpeed;
        this.preySpeed = preySpeed;
        this.catchDistance = catchDistance;
        this.arrivals = new double[floor.size()];
        this.times = new double[floor.size()];
        this.previous = new int[floor.size()];
        this.queue = new int[floor.size() + 1];
        this.waiting = new boolean[floor.size()];
    }

    /// The place that the prey runs to next; its own when it is best to stay.
    int preyStep(int preyAt, int[] hunters) {
        next = hunters;
        left = new double[hunters.length];
        prey = preyAt;
        return flee();
    }

    /// How much is left to the prey after the hunters have driven to their targets for a while: when hunters reach
    /// the last place that it reaches before them [s], and some for the number of such places and for the hunters'
    /// paths to the prey. The rule "cover" (A. Isaza, J. Lu, V. Bulitko, R. Greiner, "A cover-based approach to
    /// multi-agent moving target pursuit", AIIDE 2008) counts only such places.
    ///
    /// @param delay how long they drive [s]
    double freedom(int preyAt, int[] hunters, int[] targets, double delay) {
        next = hunters.clone();
        left = new double[hunters.length];
        goals = targets.clone();
        prey = preyAt;
        for (double time = 0; time < delay; time += STEP) {
            for (int hunter = 0; hunter < next.length; hunter++) {
                moveHunter(hunter);
            }
            if (nearest() < catchDistance) {
                return time - CAUGHT;
            }
        }
        reach();
        double latest = 0;
        for (int place = 0; place < times.length; place++) {
            if (times[place] < Double.POSITIVE_INFINITY) {
                latest = Math.max(latest, arrivals[place]);
            }
        }
        double paths = 0;
        for (int hunter = 0; hunter < next.length; hunter++) {
            paths += floor.distances(prey)[next[hunter]] + left[hunter];
        }
        return latest + FOR_A_PLACE * safe + FOR_A_METER * paths;
    }

    /// Path from a hunter to the prey [m].
    private double nearest() {
        double[] toPrey = floor.distances(prey);
        double nearest = Double.POSITIVE_INFINITY;
        for (int hunter = 0; hunter < next.length; hunter++) {
            nearest = Math.min(nearest, toPrey[next[hunter]] + left[hunter]);
        }
        return Math.max(0, nearest);
    }

    private void moveHunter(int hunter) {
        double budget = hunterSpeed * STEP;
        while (left[hunter] <= budget) {
            budget -= left[hunter];
            left[hunter] = 0;
            int at = next[hunter];
            if (goals[hunter] == at) {
                goals[hunter] = CHASE;
            }
            int to = floor.next(at, goals[hunter] == CHASE ? prey : goals[hunter]);
            if (to == at) {
                return;
            }
            left[hunter] = length(at, to);
            next[hunter] = to;
        }
        left[hunter] -= budget;
    }

    private double length(int from, int to) {
        int[] around = floor.neighbors(from);
        for (int i = 0; i < around.length; i++) {
            if (around[i] == to) {
                return floor.lengths(from)[i];
            }
        }
        throw new IllegalArgumentException("Places '%d' and '%d' are not neighbors.".formatted(from, to));
    }

    private double arrival(int place) {
        double first = Double.POSITIVE_INFINITY;
        for (int hunter = 0; hunter < next.length; hunter++) {
            first = Math.min(first, floor.distances(next[hunter])[place] + left[hunter]);
        }
        return Math.max(0, first - catchDistance) / hunterSpeed;
    }

    private int flee() {
        reach();
        int best = prey;
        for (int place = 0; place < times.length; place++) {
            if (times[place] < Double.POSITIVE_INFINITY && arrivals[place] > arrivals[best]) {
                best = place;
            }
        }
        if (safe <= 1) { // it can only run from the nearest
            for (int around : floor.neighbors(prey)) {
                if (arrival(around) > arrival(best)) {
                    best = around;
                }
            }
            return best;
        }
        while (best != prey && previous[best] != prey) {
            best = previous[best];
        }
        return best;
    }

    /// The places that the prey reaches before any hunter.
    private void reach() {
        Arrays.fill(times, Double.POSITIVE_INFINITY);
        times[prey] = 0;
        arrivals[prey] = arrival(prey);
        safe = 1;
        int head = 0;
        int tail = 0;
        queue[tail++] = prey;
        while (head != tail) {
            int place = queue[head];
            head = head + 1 == queue.length ? 0 : head + 1;
            waiting[place] = false;
            int[] around = floor.neighbors(place);
            double[] lengths = floor.lengths(place);
            for (int i = 0; i < around.length; i++) {
                int to = around[i];
                double time = times[place] + lengths[i] / preySpeed;
                if (time >= times[to]) {
                    continue;
                }
                boolean fresh = times[to] == Double.POSITIVE_INFINITY;
                double theirs = fresh ? arrival(to) : arrivals[to];
                if (time + MARGIN < theirs) {
                    safe += fresh ? 1 : 0;
                    times[to] = time;
                    arrivals[to] = theirs;
                    previous[to] = place;
                    if (!waiting[to]) {
                        waiting[to] = true;
                        queue[tail] = to;
                        tail = tail + 1 == queue.length ? 0 : tail + 1;
                    }
                }
            }
        }
    }
}
