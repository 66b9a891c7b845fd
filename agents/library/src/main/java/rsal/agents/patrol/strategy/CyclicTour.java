package rsal.agents.patrol.strategy;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// One tour of all robots in one direction: the cyclic strategy of Y. Chevaleyre, "Theoretical analysis of the
/// multi-agent patrolling problem" (2004).
public final class CyclicTour implements PatrolStrategyType {
    private static final Parameter<Double> SPACING = Parameter.number(
            "spacing",
            0,
            0,
            0.95,
            "",
            "Share of the time between two visits that robots keep apart: the one behind waits. 0: it never waits.");

    @Override
    public String key() {
        return "cycle";
    }

    @Override
    public String description() {
        return "One short tour over all places; all robots follow it in the same direction, evenly spaced at first.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(SPACING);
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new TourFollower(PatrolPlan::cycle, arguments.get(SPACING), false);
    }
}
