package rsal.scenario;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Calls itself like another.
public final class SecondSentry implements AgentType {
    @Override
    public String key() {
        return "sentry";
    }

    @Override
    public String description() {
        return "Calls itself like another.";
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
        return _ -> {};
    }
}
