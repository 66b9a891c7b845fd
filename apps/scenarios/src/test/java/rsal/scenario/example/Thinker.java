package rsal.scenario.example;

import java.util.List;
import java.util.concurrent.locks.LockSupport;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Begins to think and does not come back until it is interrupted.
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
    public List<Parameter> parameters() {
        return List.of();
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of();
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
