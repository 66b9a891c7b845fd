package rsal.testkit.fake;

import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// A type of one agent, for tests that write it where they use it.
public record TestedType(Agent agent) implements AgentType {
    @Override
    public String key() {
        return "tested";
    }

    @Override
    public String description() {
        return "Does what a test wants.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return agent;
    }
}
