package rsal.agent.platform;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// The lane of an agent that has a thread of its own, for hosts on real time: the run's scheduler knows when something
/// is due; the agent's thread does it, in turn with all else of the run ([Scheduler#exclusively]), so that devices and
/// other agents need no locks.
///
/// Its methods may be called as those of the run's scheduler may.
public final class ThreadLane implements Scheduler {
    private final Scheduler run;
    private final Executor thread;

    /// @param thread runs what it is handed one after the other, in that order, later; may drop it once the agent has
    /// ended
    public ThreadLane(Scheduler run, Executor thread) {
        this.run = run;
        this.thread = thread;
    }

    @Override
    public Object run() {
        return run.run();
    }

    @Override
    public Instant instant() {
        return run.instant();
    }

    @Override
    public void execute(Runnable task) {
        thread.execute(() -> run.exclusively(task));
    }

    @Override
    public void exclusively(Runnable task) {
        run.exclusively(task);
    }

    /// What is due at once goes to the thread at once, so that it stays before what is handed in later.
    @Override
    public Task after(Duration delay, Phase phase, Runnable task) {
        var handed = new Handed(task);
        if (!delay.isPositive()) {
            handed.hand();
            return () -> handed.cancel(() -> {});
        }
        Task timer = run.after(delay, phase, handed::hand);
        return () -> handed.cancel(timer);
    }

    /// Skips the beats that come while one still waits for the thread.
    @Override
    public Task every(Duration period, Phase phase, Runnable task) {
        var handed = new Handed(task);
        Task timer = run.every(period, phase, handed::hand);
        return () -> handed.cancel(timer);
    }

    @Override
    public <T> CompletionStage<T> compute(Supplier<T> work) {
        var result = new CompletableFuture<T>();
        run.compute(work)
                .whenComplete((value, error) -> execute(() -> {
                    if (error == null) {
                        result.complete(value);
                    } else {
                        result.completeExceptionally(error);
                    }
                }));
        return result;
    }

    /// Something that is due now or again and again. All in turn.
    private final class Handed {
        private final Runnable task;
        private boolean waiting;
        private boolean cancelled;

        Handed(Runnable task) {
            this.task = task;
        }

        void hand() {
            if (!waiting) {
                waiting = true;
                execute(this::run);
            }
        }

        private void run() {
            waiting = false;
            if (!cancelled) {
                task.run();
            }
        }

        void cancel(Task timer) {
            cancelled = true;
            timer.cancel();
        }
    }
}
