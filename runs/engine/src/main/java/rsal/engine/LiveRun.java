package rsal.engine;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.Predicate;
import rsal.device.Subscription;
import rsal.engine.report.Performance;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.engine.report.SentGoal;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunPlan;

/// The handle of a run that goes on or has ended. All methods may be called from any thread; listeners are
/// called on the run's thread and must be quick.
///
/// How a run is watched, paused and paced never changes what happens in it. What its [#operator] tells it does.
/// A run in real time can't be paused or paced: it goes on at speed 1.
public final class LiveRun implements AutoCloseable {
    private final RunLoop loop;
    private final RunOperator operator;
    private final RunInspector inspector;
    private final CompletableFuture<Snapshot> ended; // fails then; one for all waits, which it keeps none of

    LiveRun(RunLoop loop) {
        this.loop = loop;
        this.operator = new RunOperator(loop);
        this.inspector = new RunInspector(loop);
        this.ended = loop.result().handle((_, _) -> {
            throw new IllegalStateException("The run has ended.");
        });
    }

    /// Prepares a run: see [RunBuilder#start].
    public static RunBuilder of(RunPlan plan) {
        return new RunBuilder(plan);
    }

    /// Starts a run as usual.
    public static LiveRun start(RunPlan plan) {
        return of(plan).start();
    }

    public RunPlan plan() {
        return loop.plan();
    }

    /// Tells robots, agents and the simulated world what to do.
    public RunOperator operator() {
        return operator;
    }

    /// Asks about robots and agents.
    public RunInspector inspector() {
        return inspector;
    }

    /// Completes once, on the run's thread, when the run has ended and freed everything; exceptionally with
    /// [rsal.engine.report.RunBroken] when it could not go on. On another thread, and before anything is freed,
    /// when an agent never returns.
    public CompletionStage<RunResult> result() {
        return loop.result().minimalCompletionStage();
    }

    /// Lets time stand still.
    public void pause() {
        loop.pause();
    }

    public void resume() {
        loop.resume();
    }

    /// Goes on for one step while it is paused.
    public void step() {
        loop.step();
    }

    /// Sets the pace.
    ///
    /// @param factor simulated over real time; +∞ for as fast as it can
    /// @throws IllegalArgumentException when it is not positive
    public void speed(double factor) {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("A speed must be positive, not '%s'.".formatted(factor));
        }
        if (loop.isSimulated()) {
            loop.speed(factor);
        }
    }

    /// Ends the run with the outcome `stopped`.
    public void stop() {
        loop.stop();
    }

    /// Simulated time since the run's start; zero before its robots are there. Unlike [#snapshot] it costs nothing.
    public Duration elapsed() {
        return loop.elapsed();
    }

    /// Whether time stands still. Unlike [#snapshot] it costs nothing.
    public boolean isPaused() {
        return loop.pausing().isPaused();
    }

    /// The newest there is. Asking for it asks for a newer one, too, of all robots and agents: those that ask again
    /// and again slow the run down.
    public Snapshot snapshot() {
        loop.snapshots().want();
        loop.wake();
        return loop.snapshots().newest();
    }

    /// How the run is now: a snapshot that is made after this was asked, as the newest may be of long ago. Completes on
    /// the run's thread; when the run is over, at once with its last.
    public CompletionStage<Snapshot> freshSnapshot() {
        return when(_ -> true).exceptionally(_ -> loop.snapshots().newest());
    }

    /// The first snapshot from now on of which something is true. Completes on the run's thread; exceptionally
    /// with an [IllegalStateException] when the run ends before.
    ///
    /// @param wanted is asked on the run's thread, and must be quick
    public CompletionStage<Snapshot> when(Predicate<Snapshot> wanted) {
        var found = new CompletableFuture<Snapshot>();
        Subscription looking = onSnapshot(() -> {
            if (wanted.test(loop.snapshots().newest())) {
                found.complete(loop.snapshots().newest());
            } else {
                loop.snapshots().want();
            }
        });
        snapshot(); // asks for the first
        return found.applyToEither(ended, Function.identity()).whenComplete((_, _) -> looking.cancel());
    }

    /// Tells when there is a new snapshot. A listener that throws is told no more.
    public Subscription onSnapshot(Runnable listener) {
        return loop.snapshots().viewers().add(listener);
    }

    /// What has happened after an event, oldest first.
    ///
    /// @param sequence of that event; 0 for all
    public List<RunEvent> events(long sequence) {
        return loop.eventLog().after(sequence);
    }

    /// Tells when there is a new event. A listener that throws is told no more.
    public Subscription onEvents(Runnable listener) {
        return loop.eventViewers().add(listener);
    }

    /// Where people sent robots, oldest first; of those goals that ended the last 200.
    public List<SentGoal> goals() {
        return loop.goals().all();
    }

    /// What the run has counted so far; also when it has ended. Never waits for the run.
    public Performance performance() {
        snapshot(); // asks for a newer one
        return loop.performance();
    }

    /// Has the run remember what was said all the time, in 16 MB; and, once it ends, what its [#inspector]
    /// answers then about readings, minds, messages and topics. Otherwise such questions are refused when it is
    /// over. A run that ends for lack of memory remembers nothing.
    public void remember() {
        loop.remember(true);
    }

    /// Ends the run, if it has not ended, and waits up to a second until it has.
    @Override
    public void close() {
        loop.remember(false); // nobody looks at it any more
        stop();
        loop.awaitEnd();
    }
}
