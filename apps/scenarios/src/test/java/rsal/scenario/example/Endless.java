package rsal.scenario.example;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// Does not return after a second, until somebody lets it.
public final class Endless implements AgentType {
    public static final CountDownLatch RELEASE = new CountDownLatch(1);

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
            try {
                RELEASE.await();
            } catch (InterruptedException e) {
                throw new AssertionError("Nobody interrupts it.", e);
            }
        });
    }
}
