package rsal.testkit.example;

import java.time.Duration;
import java.util.concurrent.Semaphore;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// Does not return after a second, until somebody lets it.
public final class Endless implements AgentType {
    public static final Semaphore RELEASE = new Semaphore(0);

    @Override
    public String key() {
        return "endless";
    }

    @Override
    public String description() {
        return "Does not return after a second.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> self.scheduler().after(Duration.ofSeconds(1), () -> {
            RELEASE.acquireUninterruptibly(); // called by code of its own, which is where it is found
        });
    }
}
