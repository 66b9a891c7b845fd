package rsal.agents.patrol.strategy;

import java.util.Arrays;
import rsal.settings.Arguments;

/// Concurrent Bayesian learning strategy (CBLS): D. Portugal and R. Rocha, "Cooperative multi-robot patrol with
/// Bayesian learning" (2016). Values of edges are learned: after a choice, that of the neighbor with the fewest
/// visits per neighbor of its own rises, that with the most falls, weighted by the entropy of the choice.
public final class ConcurrentLearning implements PatrolStrategyType {
    private static final double OWN = 0.75; // of a neighbor's idleness, against that behind it
    private static final double STEP = 0.1; // of what is learned

    @Override
    public String key() {
        return "cbls";
    }

    @Override
    public String description() {
        return "To a neighbor where nobody goes, by idleness and by what was learned at each place.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new Learning();
    }

    private static final class Learning implements PatrolStrategy {
        private double[] values = {}; // by edge, from × size + to
        private double[] seen = {}; // last known visit, by place
        private int[] visits = {}; // as heard of, by place

        @Override
        public int next(PatrolView view) {
            int size = view.graph().size();
            if (visits.length != size) {
                values = new double[size * size];
                Arrays.fill(values, 1);
                seen = new double[size];
                visits = new int[size];
            }
            for (int place = 0; place < size; place++) {
                if (view.visited(place) > seen[place]) {
                    seen[place] = view.visited(place);
                    visits[place]++;
                }
            }
            int here = view.here();
            int[] around = Choices.around(view);
            int[] open = Arrays.stream(around)
                    .filter(place -> view.intended(place) == 0)
                    .toArray();
            int[] choices = open.length == 0 ? around : open;
            double[] worth = Arrays.stream(choices)
                    .mapToDouble(place -> values[here * size + place] * prior(view, place))
                    .toArray();
            double sum = Math.max(Arrays.stream(worth).sum(), 1e-9);
            int chosen = Choices.best(choices, place -> values[here * size + place] * prior(view, place));
            learn(view, here, around, entropy(worth, sum));
            return chosen;
        }

        /// Its own idleness, and the largest mean of the idleness around a place behind it.
        private static double prior(PatrolView view, int place) {
            double behind = 0;
            for (int next : view.graph().neighbors(place)) {
                double mean = Arrays.stream(view.graph().neighbors(next))
                        .mapToDouble(view::idle)
                        .average()
                        .orElse(0);
                behind = Math.max(behind, mean);
            }
            return OWN * view.idle(place) + (1 - OWN) * behind;
        }

        /// From 0 when one choice has all the worth to 1 when all are equal.
        private static double entropy(double[] worth, double sum) {
            if (worth.length < 2) {
                return 0;
            }
            double entropy = 0;
            for (double each : worth) {
                double share = each / sum;
                entropy -= share > 0 ? share * Math.log(share) : 0;
            }
            return entropy / Math.log(worth.length);
        }

        private void learn(PatrolView view, int here, int[] around, double weight) {
            if (around.length < 2) {
                return;
            }
            int fewest = Choices.best(around, place -> -load(view, place) + 1e-9 * view.idle(place));
            int most = Choices.best(around, place -> load(view, place) - 1e-9 * view.idle(place));
            int row = here * view.graph().size();
            values[row + fewest] = Math.min(values[row + fewest] * (1 + STEP * weight), 10);
            values[row + most] = Math.max(values[row + most] * (1 - STEP * weight), 0.1);
        }

        private double load(PatrolView view, int place) {
            return (double) visits[place] / Math.max(1, view.graph().neighbors(place).length);
        }
    }
}
