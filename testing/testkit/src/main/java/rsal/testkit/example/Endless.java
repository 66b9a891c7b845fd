package rsal.testkit.example;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicReference;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.agent.OutsideCode;
import rsal.settings.Arguments;

/// Does not return after a second, until somebody lets it.
public final class Endless implements AgentType {
    public static final Semaphore RELEASE = new Semaphore(0);

    /// Done when a run gives it up.
    public static final AtomicReference<Runnable> ELSEWHERE = new AtomicReference<>(() -> {});

    private static final OutsideCode CODE = new OutsideCode() {
        @Override
        public Optional<String> place() {
            return Optional.empty();
        }

        @Override
        public boolean isDebugged() {
            return false;
        }

        @Override
        public void kill() {
            ELSEWHERE.get().run();
        }
    };

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
        return self -> {
            self.outside(CODE);
            self.scheduler().after(Duration.ofSeconds(1), () -> {
                RELEASE.acquireUninterruptibly(); // called by code of its own, which is where it is found
            });
        };
    }
}
