package rsal.engine.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import rsal.engine.report.RunBroken;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// The run's scheduler as one part of the run gets it: when one of its tasks throws, the run learns whose it was.
public final class GuardedScheduler implements Scheduler {
    private final String owner;
    private final Scheduler scheduler;
    private final Membership membership;

    /// Whether the part has left the run.
    private static final class Membership {
        private boolean ended;
    }

    /// @param owner how messages call the part, `Device (hunter-1/localizer)`
    public GuardedScheduler(String owner, Scheduler scheduler) {
        this(owner, scheduler, new Membership());
    }

    private GuardedScheduler(String owner, Scheduler scheduler, Membership membership) {
        this.owner = owner;
        this.scheduler = scheduler;
        this.membership = membership;
    }

    /// Makes the part. When that fails, nothing runs that it has scheduled so far.
    ///
    /// @throws RunBroken when that fails
    public <T> T making(Supplier<T> part) {
        try {
            return RunBroken.blaming(owner, part);
        } catch (RunBroken e) {
            end();
            throw e;
        }
    }

    /// The part has left the run: nothing of it runs any more.
    public void end() {
        membership.ended = true;
    }

    @Override
    public Scheduler inRealTime() {
        return new GuardedScheduler(owner, scheduler.inRealTime(), membership);
    }

    @Override
    public Object run() {
        return scheduler.run();
    }

    @Override
    public Instant instant() {
        return scheduler.instant();
    }

    @Override
    public void execute(Runnable task) {
        scheduler.execute(guarded(task));
    }

    @Override
    public void exclusively(Runnable task) {
        scheduler.exclusively(guarded(task));
    }

    @Override
    public Task after(Duration delay, Phase phase, Runnable task) {
        return scheduler.after(delay, phase, guarded(task));
    }

    @Override
    public Task every(Duration period, Phase phase, Runnable task) {
        var repeated = new Task[1];
        Runnable guarded = guarded(task);
        repeated[0] = scheduler.every(period, phase, () -> {
            if (membership.ended) {
                repeated[0].cancel();
            } else {
                guarded.run();
            }
        });
        return repeated[0];
    }

    @Override
    public <T> CompletionStage<T> within(Duration limit, CompletionStage<T> stage) {
        return scheduler.within(limit, stage);
    }

    @Override
    public <T> CompletionStage<T> compute(Supplier<T> work) {
        return scheduler.compute(work);
    }

    /// The same task as one of the part: it does nothing when the part has left, and what it throws is the part's.
    public Runnable guarded(Runnable task) {
        return () -> {
            if (membership.ended) {
                return;
            }
            try {
                task.run();
            } catch (RunBroken e) {
                throw e;
            } catch (RuntimeException | Error e) {
                throw new RunBroken(owner, e);
            }
        };
    }
}
