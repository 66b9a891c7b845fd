package rsal.agents.pursuit.strategy;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Optional;

/// Where prey that nobody sees may be, and where a hunter sees most of that soonest.
///
/// A probability for each place of the floor: spreads along paths at half of the prey's top speed, half of it by
/// standing still, and is cleared where a hunter sees that no prey is there. Hunters go where they clear most per
/// second, without what others clear at their goals: the greedy rule for searchers (G. Hollinger, S. Singh, J.
/// Djugash, A. Kehagias, "Efficient multi-robot search for a moving target", IJRR 2009), with one place as the horizon.
final class BeliefSearch {
    private static final double SIGHT = 10; // m, where prey are not seen but heard
    private static final double SOON = 3.0; // s added to each drive, so that near places do not count without end
    private static final double BETTER = 1.3; // times as much per second before it changes its goal
    private static final double THERE = 0.8; // m
    private static final double STEP = 1.0; // s

    private final FloorGraph floor;
    private final double hunterSpeed;
    private final double preySpeed;
    private double[] mass;
    private double[] spread;
    private double time = Double.NaN; // of the mass [s]
    private int goal = FloorGraph.NONE;

    BeliefSearch(FloorGraph floor, double hunterSpeed, double preySpeed) {
        this.floor = floor;
        this.hunterSpeed = hunterSpeed;
        this.preySpeed = preySpeed;
        this.mass = new double[floor.size()];
        this.spread = new double[floor.size()];
        Arrays.fill(mass, 1.0 / mass.length);
    }

    /// Probability that an unseen prey is at a place.
    double probability(int place) {
        return mass[place];
    }

    /// Takes in what the hunters know now.
    void update(PursuitView view) {
        if (view.prey().isEmpty()) {
            double now = view.time();
            for (time = Double.isNaN(time) ? now : time; time + STEP <= now; time += STEP) {
                spread();
            }
            clear(view);
        } else {
            Arrays.fill(mass, 0);
            view.prey()
                    .values()
                    .forEach(prey -> mass[floor.nearest(prey.position())] +=
                            1.0 / view.prey().size());
            time = view.time();
            goal = FloorGraph.NONE;
        }
    }

    private void spread() {
        Arrays.fill(spread, 0);
        for (int place = 0; place < mass.length; place++) {
            int[] around = floor.neighbors(place);
            double[] lengths = floor.lengths(place);
            double leaves = 0;
            for (int i = 0; i < around.length; i++) {
                double share = 0.5 * Math.min(1, preySpeed * STEP / lengths[i]) / around.length;
                spread[around[i]] += share * mass[place];
                leaves += share;
            }
            spread[place] += (1 - leaves) * mass[place];
        }
        double[] before = mass;
        mass = spread;
        spread = before;
    }

    private void clear(PursuitView view) {
        double sight = sight(view);
        view.hunters().values().forEach(hunter -> {
            BitSet seen = floor.seen(floor.nearest(hunter.position()), sight);
            seen.stream().forEach(place -> mass[place] = 0);
        });
        double sum = 0;
        for (double one : mass) {
            sum += one;
        }
        for (int place = 0; place < mass.length; place++) {
            mass[place] = sum > 0 ? mass[place] / sum : 1.0 / mass.length;
        }
    }

    private static double sight(PursuitView view) {
        return view.sight() > 0 ? view.sight() : SIGHT;
    }

    /// Where the hunter sees most of what is left per second.
    Optional<PursuitOrder> decide(PursuitView view) {
        double sight = sight(view);
        double[] left = mass.clone();
        view.goals()
                .values()
                .forEach(other ->
                        floor.seen(floor.nearest(other), sight).stream().forEach(place -> left[place] = 0));
        int here = floor.nearest(view.mapFromBase().position());
        double[] distances = floor.distances(here);
        int best = here;
        double most = Double.NEGATIVE_INFINITY;
        for (int place = 0; place < mass.length; place++) {
            if (!(distances[place] < Double.POSITIVE_INFINITY)) {
                continue;
            }
            BitSet seen = floor.seen(place, sight);
            double found = 0;
            for (int one = seen.nextSetBit(0); one >= 0; one = seen.nextSetBit(one + 1)) {
                found += left[one];
            }
            double worth = found / (distances[place] / hunterSpeed + SOON) * (place == goal ? BETTER : 1);
            if (worth > most) {
                most = worth;
                best = place;
            }
        }
        goal = floor.place(best).distanceTo(view.mapFromBase().position()) < THERE ? FloorGraph.NONE : best;
        return Optional.of(PursuitOrder.search(floor.place(best)));
    }
}
