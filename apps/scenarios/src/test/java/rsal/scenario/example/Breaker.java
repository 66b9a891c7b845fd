package rsal.scenario.example;

import java.time.Duration;
import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

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
    public List<Parameter> parameters() {
        return List.of();
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of();
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
            throw new IllegalStateException("a screw is loose");
        });
    }
}
