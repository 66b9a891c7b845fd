package rsal.agents.pursuit.strategy;

import java.util.Arrays;

/// How a hunt goes on, on the places of a floor: hunters drive to goals and then chase, by shortest paths; the prey
/// flees from hunters that are near by TrailMax, and else keeps its direction. All move at constant speeds, and turn in
/// no time.
///
/// TrailMax (C. Moldenhauer and N. R. Sturtevant, "Evaluating strategies for running from the cops", IJCAI 2009): of the
/// places that the prey reaches before any hunter, on paths of such places, it runs to the one that hunters reach last.
/// Differs in that the prey may go out of its way only by whole places, and decides again at each.
final class PursuitModel {
    /// Of a hunter that chases.
    static final int CHASE = FloorGraph.NONE;

    private static final double STEP = 1.0; // s
    private static final double MARGIN = 0.5; // s by which the prey has to be sooner

    private final FloorGraph floor;
    private final double hunterSpeed;
    private final double preySpeed;
    private final double catchDistance;
    private final double awareness; // m, straight, from which on prey flee
    private final double horizon; // s
    private final double[] arrivals; // of hunters [s], by place, for one decision
    private final double[] times; // of the prey [s]
    private final int[] previous;
    private final int[] queue;
    private final boolean[] waiting;

    // one hunt
    private int[] next = {}; // places that hunters drive to now
    private double[] left = {}; // m to there
    private int[] goals = {};
    private int prey;
    private int preyFrom;
    private double preyLeft; // m to `prey`
    private int safe; // places, at the prey's last decision

    PursuitModel(
            FloorGraph floor,
            double hunterSpeed,
            double preySpeed,
            double catchDistance,
            double awareness,
            double horizon) {
        this.floor = floor;
        this.hunterSpeed = hunterSpeed;
        this.preySpeed = preySpeed;
        this.catchDistance = catchDistance;
        this.awareness = awareness;
        this.horizon = horizon;
        this.arrivals = new double[floor.size()];
        this.times = new double[floor.size()];
        this.previous = new int[floor.size()];
        this.queue = new int[floor.size() + 1];
        this.waiting = new boolean[floor.size()];
    }

    /// When the prey is caught [s]; where it is not until the horizon, longer by how far hunters are from it then.
    ///
    /// @param preyAt its place
    /// @param preyBefore the place where it was before, which gives its direction; the same if it stands
    /// @param hunters their places
    /// @param targets where they drive at first, or [#CHASE]
    double captureTime(int preyAt, int preyBefore, int[] hunters, int[] targets) {
        next = hunters.clone();
        left = new double[hunters.length];
        goals = targets.clone();
        prey = preyAt;
        preyFrom = preyBefore;
        preyLeft = 0;
        for (double time = 0; time < horizon; time += STEP) {
            double nearest = nearest();
            if (nearest <= catchDistance) {
                return time - (catchDistance - nearest) / (hunterSpeed + preySpeed);
            }
            movePrey();
            for (int hunter = 0; hunter < next.length; hunter++) {
                moveHunter(hunter);
            }
        }
        return horizon + nearest() / hunterSpeed;
    }

    /// Path from a hunter to the prey [m].
    private double nearest() {
        double[] toPrey = floor.distances(prey);
        double nearest = Double.POSITIVE_INFINITY;
        for (int hunter = 0; hunter < next.length; hunter++) {
            nearest = Math.min(nearest, toPrey[next[hunter]] + left[hunter] - preyLeft);
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
        throw new IllegalArgumentException("Places '%d' and '%d' are no neighbors.".formatted(from, to));
    }

    private void movePrey() {
        double budget = preySpeed * STEP;
        while (preyLeft <= budget) {
            budget -= preyLeft;
            preyLeft = 0;
            int to = choosePreyStep();
            if (to == prey) {
                return;
            }
            preyLeft = length(prey, to);
            preyFrom = prey;
            prey = to;
        }
        preyLeft -= budget;
    }

    private int choosePreyStep() {
        boolean aware = false;
        for (int hunter : next) {
            aware |= floor.place(hunter).distanceTo(floor.place(prey)) < awareness;
        }
        return aware ? flee() : straightOn();
    }

    private int straightOn() {
        if (preyFrom == prey) {
            return prey;
        }
        double dx = floor.place(prey).x() - floor.place(preyFrom).x();
        double dy = floor.place(prey).y() - floor.place(preyFrom).y();
        int best = prey;
        double straightest = Double.NEGATIVE_INFINITY;
        for (int around : floor.neighbors(prey)) {
            double x = floor.place(around).x() - floor.place(prey).x();
            double y = floor.place(around).y() - floor.place(prey).y();
            double cosine = (dx * x + dy * y) / Math.sqrt((dx * dx + dy * dy) * (x * x + y * y));
            if (cosine > straightest) {
                straightest = cosine;
                best = around;
            }
        }
        return best;
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
