package rsal.agents.patrol.strategy;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Places as tasks of a contract net, which an agent without a robot calls; it alone decides. As a strategy of
/// one robot, as in [IdealPatrol], the place with the lowest bid that nobody else goes to.
public final class Bids implements PatrolStrategyType {
    public static final Parameter<Double> URGENCY = Parameter.number(
            "urgency",
            0.5,
            0,
            100,
            "m/s",
            "How much longer a path may be for each second since the last visit of a place.");
    private static final double SEEN = 10; // s, as long as nobody calls for bids

    @Override
    public String key() {
        return "bids";
    }

    @Override
    public String description() {
        return "The robots bid for each place: a short path and a long time since the last visit lower a bid.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(URGENCY);
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        double urgency = arguments.get(URGENCY);
        return view -> Choices.best(Choices.others(view), place -> {
            boolean open = view.intended(place) == 0 && view.idle(place) >= SEEN;
            return (open ? 0 : -1e6) + urgency * view.idle(place) - view.lengthTo(place);
        });
    }
}
