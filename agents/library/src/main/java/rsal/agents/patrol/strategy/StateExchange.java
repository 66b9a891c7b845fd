package rsal.agents.patrol.strategy;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// State exchange Bayesian strategy (SEBS): D. Portugal and R. Rocha, "Multi-robot patrolling algorithms:
/// examining performance and scalability" (2013). The probability of [BayesianGain] is multiplied by 2^(N - c)
/// / (2^N - 1) where c of N robots intend to go.
public final class StateExchange implements PatrolStrategyType {

    @Override
    public String key() {
        return "sebs";
    }

    @Override
    public String description() {
        return "To the neighbor with the largest gain, less where other robots go.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return BayesianGain.ALL;
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        BayesianGain gain = BayesianGain.of(arguments);
        return view -> Choices.best(Choices.around(view), place -> value(view, gain, place));
    }

    private static double value(PatrolView view, BayesianGain gain, int place) {
        int others = view.intended(place);
        double factor =
                others == 0 ? 1 : Math.scalb(1.0, view.members() - others) / (Math.scalb(1.0, view.members()) - 1);
        return gain.probability(view, place) * factor;
    }
}
