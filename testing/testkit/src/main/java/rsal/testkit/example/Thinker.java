package rsal.testkit.example;

import java.util.concurrent.locks.LockSupport;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;
import rsal.time.AllowedToReadWallClock;

/// Begins to think and does not come back until it is interrupted.
@AllowedToReadWallClock("It holds its thread up, on purpose.")
public final class Thinker implements AgentType {
    @Override
    public String key() {
        return "thinker";
    }

    @Override
    public String description() {
        return "Thinks for ever.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return _ -> {
            while (!Thread.currentThread().isInterrupted()) {
                LockSupport.park(this);
            }
        };
    }
}
