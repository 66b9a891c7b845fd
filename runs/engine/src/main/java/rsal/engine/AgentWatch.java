package rsal.engine;

import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import rsal.agent.OutsideCode;
import rsal.agent.platform.AgentTurns;
import rsal.engine.report.RunBroken;
import rsal.settings.OwnCode;

/// Looks once a second, on a thread of its own, whether the agents of a run return.
final class AgentWatch {
    private static final Duration PERIOD = Duration.ofSeconds(1);

    private final AgentTurns turns;
    private final int patience;
    private final Watchdog watchdog;
    private final CompletableFuture<Boolean> ending;
    private final Consumer<RunBroken> giveUp;

    /// @param patience after how many looks an agent counts as one that never returns
    /// @param result done when the run has ended; then it looks no more
    /// @param giveUp told which agent never returns
    AgentWatch(AgentTurns turns, int patience, CompletableFuture<?> result, Consumer<RunBroken> giveUp) {
        this.turns = turns;
        this.patience = patience;
        this.watchdog = new Watchdog(turns, patience);
        this.ending = result.handle((_, _) -> true);
        this.giveUp = giveUp;
    }

    /// For somebody who looks once a second.
    AgentWatch(AgentTurns turns, int patience) {
        this(turns, patience, new CompletableFuture<>(), _ -> {});
    }

    /// Until the run has ended.
    void run() {
        while (!ending.isDone()) {
            try {
                ending.get(PERIOD.toMillis(), TimeUnit.MILLISECONDS);
            } catch (TimeoutException _) {
                tell();
            } catch (InterruptedException | ExecutionException e) {
                throw new AssertionError("Nobody interrupts it, and both endings are handled.", e);
            }
        }
    }

    /// Which agent has not returned, and where it is.
    Optional<RunBroken> look() {
        return watchdog.look().map(this::broken);
    }

    private void tell() {
        try {
            look().ifPresent(broken -> {
                giveUp.accept(broken);
                turns.inProgress()
                        .keySet()
                        .forEach(agent -> turns.outside(agent).ifPresent(OutsideCode::kill));
            });
        } catch (OutOfMemoryError _) {
            // what the run does about it is its own matter; the next look may have enough
        }
    }

    private RunBroken broken(String agent) {
        return new RunBroken(
                "Agent '%s' has not returned for %d s; it is at %s. An agent must return soon: maybe wait by a timer, a callback or 'await'."
                        .formatted(agent, patience, place(agent)));
    }

    private String place(String agent) {
        return turns.outside(agent).flatMap(OutsideCode::place).orElseGet(() -> place(turns.thread(agent)));
    }

    /// The thread of an agent at work, as platforms may have threads of their own.
    static Optional<Thread> busyThread(AgentTurns turns) {
        return turns.inProgress().keySet().stream().findFirst().flatMap(turns::thread);
    }

    /// Where a thread is, beside what Java itself does there.
    static String place(Optional<Thread> busy) {
        return busy.map(Thread::getStackTrace).stream()
                .flatMap(Arrays::stream)
                .filter(frame -> !frame.getClassName().matches("(java|javax|jdk|sun)\\..*"))
                .findFirst()
                .map(OwnCode::place)
                .orElse("nothing");
    }
}
