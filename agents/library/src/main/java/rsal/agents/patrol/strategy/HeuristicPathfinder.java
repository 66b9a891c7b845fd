package rsal.agents.patrol.strategy;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import rsal.settings.Arguments;

/// Heuristic pathfinder conscientious cognitive: A. Almeida et al., "Recent advances on multi-agent patrolling"
/// (2004). A step of the path costs its share of the longest path, plus 1 less the place's share of the largest
/// idleness.
public final class HeuristicPathfinder implements PatrolStrategyType {

    @Override
    public String key() {
        return "hpcc";
    }

    @Override
    public String description() {
        return "To the place with the best sum of idleness and nearness, on a path over idle places.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new Planned();
    }

    private static final class Planned implements PatrolStrategy {
        private final Deque<Integer> path = new ArrayDeque<>();

        @Override
        public int next(PatrolView view) {
            if (path.isEmpty()) {
                double longest = Choices.longest(view.graph());
                double idlest = Math.max(view.mostIdle(), 1e-9);
                int target = Choices.best(
                        Choices.others(view), place -> view.idle(place) / idlest + 1 - view.lengthTo(place) / longest);
                plan(view, target, longest, idlest);
            }
            return path.remove();
        }

        /// By Dijkstra's algorithm over neighbors.
        private void plan(PatrolView view, int target, double longest, double idlest) {
            PatrolGraph graph = view.graph();
            var costs = new double[graph.size()];
            var from = new int[graph.size()];
            var done = new boolean[graph.size()];
            Arrays.fill(costs, Double.POSITIVE_INFINITY);
            Arrays.fill(from, PatrolView.NONE);
            int here = view.here();
            costs[here] = 0;
            while (here != PatrolView.NONE && here != target) {
                done[here] = true;
                for (int next : graph.neighbors(here)) {
                    double cost = costs[here] + graph.length(here, next) / longest + 1 - view.idle(next) / idlest;
                    if (!done[next] && cost < costs[next]) {
                        costs[next] = cost;
                        from[next] = here;
                    }
                }
                here = PatrolView.NONE;
                for (int place = 0; place < costs.length; place++) {
                    boolean open = !done[place] && Double.isFinite(costs[place]);
                    here = open && (here == PatrolView.NONE || costs[place] < costs[here]) ? place : here;
                }
            }
            path.add(target);
            for (int place = from[target]; place != PatrolView.NONE && place != view.here(); place = from[place]) {
                path.addFirst(place);
            }
        }
    }
}
