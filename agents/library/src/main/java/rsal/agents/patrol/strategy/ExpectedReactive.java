package rsal.agents.patrol.strategy;

import rsal.settings.Arguments;

/// Expected reactive: C. Yan and T. Zhang, "Multi-robot patrol: a distributed algorithm based on expected
/// idleness" (2016).
public final class ExpectedReactive implements PatrolStrategyType {
    private static final double SHORTEST = 0.5; // m

    @Override
    public String key() {
        return "er";
    }

    @Override
    public String description() {
        return "To the neighbor with the largest idleness at arrival per length of the path; where another arrives earlier, counted from then.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return view -> Choices.best(Choices.around(view), place -> value(view, place));
    }

    private static double value(PatrolView view, int place) {
        double length = view.lengthTo(place);
        double arrival = view.now() + length / view.graph().speed();
        double since = view.visited(place);
        for (int member = 0; member < view.members(); member++) {
            if (member != view.self() && view.next(member) == place && view.arrival(member) < arrival) {
                since = Math.max(since, view.arrival(member));
            }
        }
        return (arrival - since) / Math.max(length, SHORTEST);
    }
}
