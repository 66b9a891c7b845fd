package rsal.testkit.example;

import java.time.Duration;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// Breaks the run after a second: throws what a fence around an agent does not hold.
public final class Wrecker implements AgentType {
    @Override
    public String key() {
        return "wrecker";
    }

    @Override
    public String description() {
        return "Breaks the run after a second.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
            throw new InternalError("the machine is out of order");
        });
    }
}
