package rsal.agents.patrol.strategy;

import rsal.settings.Arguments;

/// Heuristic conscientious reactive: A. Almeida et al., "Recent advances on multi-agent patrolling" (2004).
public final class HeuristicReactive implements PatrolStrategyType {

    @Override
    public String key() {
        return "hcr";
    }

    @Override
    public String description() {
        return "To the neighbor with the best sum of idleness and nearness, both as shares of the largest.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return HeuristicReactive::next;
    }

    private static int next(PatrolView view) {
        int[] around = Choices.around(view);
        double idlest = 1e-9;
        double farthest = 1e-9;
        for (int place : around) {
            idlest = Math.max(idlest, view.idle(place));
            farthest = Math.max(farthest, view.lengthTo(place));
        }
        double mostIdle = idlest;
        double mostFar = farthest;
        return Choices.best(around, place -> view.idle(place) / mostIdle + 1 - view.lengthTo(place) / mostFar);
    }
}
