package rsal.scenario.run;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.device.Subscription;
import rsal.scenario.RunPlan;
import rsal.time.AllowedToReadWallClock;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;

/// A run under way, or ended. All methods may be called from any thread; listeners are called on the run's thread
/// and must be quick.
///
/// The run has a thread of its own, `run-<n>`, and helpers for heavy work, `run-<n>-helper-<m>`. Between two steps
/// it takes commands and makes a snapshot if somebody wants one. How it is watched, paused and paced never changes
/// what happens in it; placing robots, sending them somewhere and the emergency stop do, and are events of the run.
@AllowedToReadWallClock("It holds the run back to the pace that people want to watch, and says how long it took.")
public final class LiveRun implements AutoCloseable {
    private static final Logger LOG = System.getLogger(LiveRun.class.getName());
    private static final AtomicLong RUNS = new AtomicLong();
    private static final long SNAPSHOT_PERIOD = 45_000_000; // ns
    private static final Duration PATIENCE = Duration.ofSeconds(1);

    private final RunPlan plan;
    private final Thread thread;
    private final Queue<Runnable> commands = new ConcurrentLinkedQueue<>();
    private final CompletableFuture<RunResult> result = new CompletableFuture<>();
    private final List<Runnable> snapshotListeners = new CopyOnWriteArrayList<>();
    private final List<Runnable> eventListeners = new CopyOnWriteArrayList<>();
    private final ExecutorService helpers;
    private final LockstepScheduler scheduler;
    private final Journal journal;
    private final Observer observer;
    private final Pace pace;
    private volatile Snapshot snapshot;
    private volatile boolean snapshotWanted;

    // of the run's thread
    private @Nullable Stage stage;
    private @Nullable String outcome;
    private boolean paused;
    private int stepsWanted;
    private long snapshotMade;

    private LiveRun(RunPlan plan) {
        this.plan = plan;
        String name = "run-" + RUNS.incrementAndGet();
        this.helpers = helpers(name);
        this.scheduler = new LockstepScheduler(Instant.EPOCH, helpers);
        this.journal = new Journal(scheduler::elapsed, () -> eventListeners.forEach(Runnable::run));
        this.observer = new Observer(plan, journal, scheduler);
        this.pace = new Pace(System::nanoTime, plan.speed());
        this.snapshot =
                new Snapshot(0, Duration.ZERO, false, false, plan.speed(), 0, Optional.empty(), List.of(), List.of());
        this.thread = Thread.ofPlatform().name(name).daemon().unstarted(this::run);
    }

    /// Starts a run. Robots and agents are made on its own thread; what goes wrong there ends its [#result].
    public static LiveRun start(RunPlan plan) {
        var run = new LiveRun(plan);
        run.thread.start();
        return run;
    }

    private static ExecutorService helpers(String run) {
        int number = Math.max(1, Runtime.getRuntime().availableProcessors() - 1);
        return Executors.newFixedThreadPool(
                number, Thread.ofPlatform().daemon().name(run + "-helper-", 1).factory());
    }

    public RunPlan plan() {
        return plan;
    }

    /// Completes once, on the run's thread, when the run has ended and let go of everything; exceptionally with
    /// [RunBroken] when it could not go on.
    public CompletionStage<RunResult> result() {
        return result.minimalCompletionStage();
    }

    /// Lets time stand still.
    public void pause() {
        command(() -> paused = true);
    }

    public void resume() {
        command(() -> {
            paused = false;
            pace.restart(scheduler.elapsed().toNanos());
        });
    }

    /// Goes on for one step while it is paused.
    public void step() {
        command(() -> stepsWanted += paused ? 1 : 0);
    }

    /// Sets the pace.
    ///
    /// @param factor simulated over real time; +∞ for as fast as it can
    /// @throws IllegalArgumentException when it is not positive
    public void speed(double factor) {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("A speed must be positive, not (%s).".formatted(factor));
        }
        command(() -> pace.speed(factor, scheduler.elapsed().toNanos()));
    }

    /// Ends the run with the outcome `stopped`.
    public void stop() {
        command(() -> end("stopped"));
    }

    /// Puts a robot somewhere: in the simulated world, if there is one, and in its localizer's belief.
    public CompletionStage<Answer> place(String robot, Pose2d mapFromBase) {
        return ask(stage -> stage.place(robot, mapFromBase));
    }

    /// Asks a robot's agent to drive somewhere.
    public CompletionStage<Answer> goTo(String robot, Pose2d mapFromGoal) {
        return ask(stage -> stage.goTo(robot, mapFromGoal));
    }

    /// Switches off all motors, until [#rearm].
    public CompletionStage<Answer> estop() {
        return ask(stage -> stage.stop(true));
    }

    public CompletionStage<Answer> rearm() {
        return ask(stage -> stage.stop(false));
    }

    /// The newest there is. Asking for it asks for a newer one, too.
    public Snapshot snapshot() {
        snapshotWanted = true;
        LockSupport.unpark(thread);
        return snapshot;
    }

    /// Tells when there is a new snapshot.
    public Subscription onSnapshot(Runnable listener) {
        snapshotListeners.add(listener);
        return () -> snapshotListeners.remove(listener);
    }

    /// What has happened after an event, oldest first.
    ///
    /// @param sequence of that event; 0 for all
    public List<RunEvent> events(long sequence) {
        return journal.after(sequence);
    }

    /// Tells when there is a new event.
    public Subscription onEvents(Runnable listener) {
        eventListeners.add(listener);
        return () -> eventListeners.remove(listener);
    }

    /// Ends the run, if it has not ended, and waits up to a second until it has.
    @Override
    public void close() {
        stop();
        if (Thread.currentThread().equals(thread)) {
            return;
        }
        try {
            if (!thread.join(PATIENCE)) {
                LOG.log(
                        Level.WARNING,
                        "{0} does not end. It is busy in {1}; maybe an agent there never returns.",
                        thread.getName(),
                        firstFrame());
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }

    private String firstFrame() {
        StackTraceElement[] frames = thread.getStackTrace();
        return frames.length == 0 ? "nothing" : frames[0].toString();
    }

    private void command(Runnable command) {
        commands.add(command);
        LockSupport.unpark(thread);
    }

    private CompletionStage<Answer> ask(Function<Stage, Answer> command) {
        var answer = new CompletableFuture<Answer>();
        command(() -> answer.complete(answer(command)));
        var tooLate = result.handle((_, _) -> (Answer) new Answer.Refused("The run has ended."));
        return answer.applyToEither(tooLate, Function.identity());
    }

    private Answer answer(Function<Stage, Answer> command) {
        if (stage == null) {
            return new Answer.Refused("The run has not begun.");
        }
        try {
            return command.apply(stage);
        } catch (IllegalArgumentException e) {
            return new Answer.Refused(String.valueOf(e.getMessage()));
        }
    }

    private void run() {
        long began = System.nanoTime();
        RunResult ended = null;
        RunBroken broken = null;
        try (helpers;
                var everything = new Stage(plan, scheduler, journal, observer)) {
            stage = everything;
            everything.begin();
            scheduler.every(
                    plan.step(), Phase.OBSERVE, () -> everything.observe().ifPresent(this::end));
            while (outcome == null) {
                turn(everything);
            }
            makeSnapshot(everything);
            ended = result(outcome, (System.nanoTime() - began) * 1e-9);
        } catch (RunBroken e) {
            broken = e;
        } catch (RuntimeException | Error e) {
            broken = new RunBroken("The run", e);
        }
        if (ended != null) {
            result.complete(ended);
        } else if (broken != null) {
            end("broken");
            journal.event("fault", "", String.valueOf(broken.getMessage()));
            result.completeExceptionally(broken);
        }
    }

    /// Takes commands, then goes on for a step or waits until it may.
    private void turn(Stage stage) {
        for (Runnable command = commands.poll(); command != null; command = commands.poll()) {
            command.run();
        }
        if (paused && stepsWanted == 0) {
            rest(stage, Long.MAX_VALUE);
            return;
        }
        long early = paused ? 0 : pace.early(scheduler.elapsed().toNanos());
        if (early > 0) {
            rest(stage, early);
            return;
        }
        stepsWanted = Math.max(0, stepsWanted - 1);
        scheduler.advance(plan.step());
        if (snapshotWanted && untilNextSnapshot() <= 0) {
            makeSnapshot(stage);
        }
    }

    /// Waits, or makes a snapshot if one is wanted; returns early when there is something to do.
    private void rest(Stage stage, long nanos) {
        long wait = nanos;
        if (snapshotWanted) {
            long until = untilNextSnapshot();
            if (until <= 0) {
                makeSnapshot(stage);
                return;
            }
            wait = Math.min(wait, until);
        }
        if (commands.isEmpty()) {
            LockSupport.parkNanos(this, wait);
        }
    }

    private void end(String how) {
        if (outcome == null) {
            outcome = how;
            journal.event("run", "", "ends: " + how);
        }
    }

    private RunResult result(String how, double wallSeconds) {
        var measures = new LinkedHashMap<String, OptionalDouble>();
        var outOfBounds = new ArrayList<String>();
        for (Observer.Finding finding : observer.findings()) {
            measures.put(finding.name(), finding.value());
            if (!finding.inBounds()) {
                outOfBounds.add(finding.name());
            }
        }
        return new RunResult(
                plan.scenario().name(),
                plan.configuration(),
                plan.seed(),
                how,
                observer.time(),
                wallSeconds,
                journal.finish(),
                measures,
                outOfBounds);
    }

    private long untilNextSnapshot() {
        return snapshotMade + SNAPSHOT_PERIOD - System.nanoTime();
    }

    private void makeSnapshot(Stage stage) {
        snapshotWanted = false;
        snapshotMade = System.nanoTime();
        snapshot = new Snapshot(
                snapshot.sequence() + 1,
                scheduler.elapsed(),
                paused,
                stage.stopped(),
                pace.speed(),
                paused ? 0 : pace.rate(scheduler.elapsed().toNanos()),
                Optional.ofNullable(outcome),
                stage.robotViews(),
                stage.agentViews());
        snapshotListeners.forEach(Runnable::run);
    }
}
