package rsal.agents.patrol.strategy;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Greedy Bayesian strategy (GBS): D. Portugal and R. Rocha, "Multi-robot patrolling algorithms: examining
/// performance and scalability" (2013). Robots do not know where others go.
public final class GreedyBayesian implements PatrolStrategyType {

    @Override
    public String key() {
        return "gbs";
    }

    @Override
    public String description() {
        return "To the neighbor with the largest gain: idleness per length of the path.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return BayesianGain.ALL;
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        BayesianGain gain = BayesianGain.of(arguments);
        return view -> Choices.best(Choices.around(view), place -> gain.probability(view, place));
    }
}
