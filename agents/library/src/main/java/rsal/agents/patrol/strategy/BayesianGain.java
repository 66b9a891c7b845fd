package rsal.agents.patrol.strategy;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// How sure a robot is to go to a place, by what it gains there: D. Portugal and R. Rocha, "Multi-robot
/// patrolling algorithms: examining performance and scalability" (2013). The gain is the idleness per meter of
/// the path; the probability grows from 0.1 at no gain to 1 at [#SATURATION].
record BayesianGain(double saturation, double shortest) {
    private static final double LEAST = 0.1; // G1 in the article

    static final Parameter<Double> SATURATION = Parameter.number(
            "saturation", 100, 0.1, 1e6, "s/m", "Gain at which the robot is sure to go there (G2 of the article).");
    static final Parameter<Double> SHORTEST =
            Parameter.number("shortest", 1, 0.01, 1000, "m", "Length that shorter paths count as.");
    static final List<Parameter<?>> ALL = List.of(SATURATION, SHORTEST);

    static BayesianGain of(Arguments arguments) {
        return new BayesianGain(arguments.get(SATURATION), arguments.get(SHORTEST));
    }

    double probability(PatrolView view, int place) {
        double gain = view.idle(place) / Math.max(view.lengthTo(place), shortest);
        return gain >= saturation ? 1 : LEAST * Math.exp(Math.log(1 / LEAST) / saturation * gain);
    }
}
