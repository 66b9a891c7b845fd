package rsal.server;

import java.util.function.Consumer;
import rsal.scenario.RunPlan;
import rsal.scenario.run.LiveRun;

/// The run that is shown, and its successors: one at a time. All methods may be called from any thread.
final class CurrentRun implements AutoCloseable {
    private final Consumer<LiveRun> onStart;
    private volatile Numbered now;
    private boolean closed;

    /// @param number counts this server's runs, from 1
    record Numbered(int number, LiveRun run) {
        boolean isOver() {
            return run.result().toCompletableFuture().isDone();
        }
    }

    CurrentRun(RunPlan first, Consumer<LiveRun> onStart) {
        this.onStart = onStart;
        now = begin(1, first);
    }

    Numbered now() {
        return now;
    }

    /// Ends the run and begins another one.
    synchronized void restart(RunPlan next) {
        if (closed) {
            throw new Refusal(503, "The server is ending.");
        }
        now.run().close();
        now = begin(now.number() + 1, next);
    }

    private Numbered begin(int number, RunPlan plan) {
        LiveRun run = LiveRun.start(plan);
        onStart.accept(run);
        return new Numbered(number, run);
    }

    @Override
    public synchronized void close() {
        closed = true;
        now.run().close();
    }
}
