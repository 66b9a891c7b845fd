package rsal.agents.patrol.strategy;

import rsal.settings.Arguments;

/// A. Machado et al., "Multi-agent patrolling: an empirical analysis of alternative architectures" (2002): each
/// robot counts only its own visits.
public final class ConscientiousReactive implements PatrolStrategyType {

    @Override
    public String key() {
        return "cr";
    }

    @Override
    public String description() {
        return "To the neighbor where the robot itself was not for the longest time.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new Own();
    }

    private static final class Own implements PatrolStrategy {
        private double[] visited = {};

        @Override
        public int next(PatrolView view) {
            if (visited.length != view.graph().size()) {
                visited = new double[view.graph().size()];
            }
            visited[view.here()] = view.now();
            int chosen = Choices.best(Choices.around(view), place -> -visited[place]);
            visited[chosen] = view.now(); // others come first when it can't get there
            return chosen;
        }
    }
}
