package rsal.testkit.example;

import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.agent.Topic;
import rsal.settings.Arguments;

/// Means something else by a topic's name than all others do.
public final class Squatter implements AgentType {
    private static final Topic<String> TEXT = new Topic<>("text", String.class);

    @Override
    public String key() {
        return "squatter";
    }

    @Override
    public String description() {
        return "Means something else by a topic's name.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> self.subscribe(TEXT, _ -> {});
    }
}
