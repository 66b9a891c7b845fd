package rsal.agents.pursuit.strategy;

import java.util.Optional;
import rsal.settings.Arguments;

/// The rule of the thesis.
public final class Direct implements PursuitStrategyType {
    @Override
    public String key() {
        return "direct";
    }

    @Override
    public String description() {
        return "To the newest pose of the prey that 'assignment' gives to the hunter, as in the thesis.";
    }

    @Override
    public PursuitStrategy create(Arguments arguments) {
        return new PursuitStrategy() {
            @Override
            public Optional<PursuitOrder> decide(PursuitView view) {
                return view.direct();
            }

            @Override
            public boolean sendsGoals() {
                return false;
            }
        };
    }
}
