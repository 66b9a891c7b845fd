package rsal.scenario;

import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// Calls itself like another.
public final class SecondWanderer implements AgentType {
    @Override
    public String key() {
        return "wanderer";
    }

    @Override
    public String description() {
        return "Calls itself like another.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return _ -> {};
    }
}
