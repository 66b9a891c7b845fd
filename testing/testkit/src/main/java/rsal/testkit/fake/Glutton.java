package rsal.testkit.fake;

import java.time.Duration;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// Has no memory left after a second: it throws what the machine would, and leaves the memory to the other tests.
public final class Glutton implements AgentType {
    @Override
    public String key() {
        return "glutton";
    }

    @Override
    public String description() {
        return "Has no memory left after a second.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
            throw new OutOfMemoryError("Java heap space");
        });
    }
}
