package rsal.agents.patrol.strategy;

import rsal.settings.Arguments;

/// What each strategy has to beat.
public final class RandomWalk implements PatrolStrategyType {

    @Override
    public String key() {
        return "random";
    }

    @Override
    public String description() {
        return "To a neighbor at random.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return view -> {
            int[] around = Choices.around(view);
            return around[view.random().nextInt(around.length)];
        };
    }
}
