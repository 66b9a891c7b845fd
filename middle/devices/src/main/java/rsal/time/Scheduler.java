package rsal.time;

import java.time.Duration;
import java.time.InstantSource;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;

/// What time it is, and which code runs when. Tasks of one scheduler never overlap: all callbacks, behaviors and
/// agents of a run live on its one thread, or on another while it is that one's turn ([#exclusively]), and need no
/// locks.
///
/// All methods but [#execute], [#exclusively] and [#instant] may only be called on the scheduler's thread, by what runs
/// exclusively, or before it runs.
public interface Scheduler extends InstantSource, Executor {
    /// Runs the task once on the scheduler's thread as soon as it may. The only way in from other threads.
    @Override
    void execute(Runnable task);

    /// Runs the task on the calling thread, at once or as soon as nothing else of the run does: for those who bring
    /// threads of their own, as multi-agent systems do. Returns when it is done. What it throws is treated as what
    /// tasks of the scheduler throw. May be called on any thread that holds nothing the run may wait for.
    ///
    /// @throws UnsupportedOperationException in simulated time, in which the order of threads must not count
    default void exclusively(Runnable task) {
        throw new UnsupportedOperationException(
                "In simulated time, everything runs on one thread. Maybe call it by " + "scheduler.execute(...).");
    }

    /// The same thread's, by real time: for what must go on while the run's time stands, as it may where another
    /// program drives it ([DrivenTime]). That is what keeps motors safe, finds robots and answers people; all
    /// else has the run's time. Itself where the run's time is real, or simulated here.
    default Scheduler inRealTime() {
        return this;
    }

    /// What tells whether two schedulers are of the same run: equal for all views of one, as parts of a run have
    /// them.
    default Object run() {
        return this;
    }

    /// Runs a task once, `delay` from now, in a phase of that instant.
    Task after(Duration delay, Phase phase, Runnable task);

    default Task after(Duration delay, Runnable task) {
        return after(delay, Phase.THINK, task);
    }

    /// Runs a task again and again, first one `period` from now. Real time skips beats it missed; it never
    /// bursts.
    Task every(Duration period, Phase phase, Runnable task);

    default Task every(Duration period, Runnable task) {
        return every(period, Phase.THINK, task);
    }

    /// The stage's own ending, or a [TimeoutException] when it has none within the limit. Comes on the scheduler's
    /// thread, whichever thread ends the stage.
    default <T> CompletionStage<T> within(Duration limit, CompletionStage<T> stage) {
        var result = new CompletableFuture<T>();
        Task timer = after(
                limit,
                () -> result.completeExceptionally(
                        new TimeoutException("No answer within %s s.".formatted(limit.toMillis() / 1000.0))));
        stage.whenComplete((value, error) -> execute(() -> {
            timer.cancel();
            if (error == null) {
                result.complete(value);
            } else {
                result.completeExceptionally(error);
            }
        }));
        return result;
    }

    /// Heavy work of one robot. It runs on another thread, beside the work that other robots hand in during the
    /// same phase, and may touch only what nobody else touches meanwhile. In simulated time it is done before the
    /// phase ends, and the stages complete on the scheduler's thread in the order in which the work was handed
    /// in; in real time each completes there when it is done.
    <T> CompletionStage<T> compute(Supplier<T> work);
}
