package rsal.testkit.example;

import java.time.Duration;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// Fails after a second.
public final class Breaker implements AgentType {
    @Override
    public String key() {
        return "breaker";
    }

    @Override
    public String description() {
        return "Fails after a second.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
            throw new IllegalStateException("a screw is loose");
        });
    }
}
