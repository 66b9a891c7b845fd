package rsal.engine;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import rsal.agent.platform.AgentTurns;
import rsal.engine.communication.Traffic;
import rsal.engine.event.EventLog;
import rsal.engine.event.RunClock;
import rsal.engine.event.Viewers;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.operator.SentGoals;
import rsal.engine.report.Answer;
import rsal.engine.report.Performance;
import rsal.engine.report.RunBroken;
import rsal.engine.report.RunResult;
import rsal.scenario.RunPlan;
import rsal.system.RobotRecorder;
import rsal.time.AllowedToReadWallClock;
import rsal.time.DrivenTime;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;
import rsal.time.PhaseTimes;
import rsal.time.Scheduler;
import rsal.time.WallScheduler;

/// Executes a run on a thread of its own, `run-<n>`, with helpers for heavy work, `run-<n>-helper-<m>`.
/// Between two steps it does what other threads have asked for. Methods that say nothing else are of the
/// run's thread.
@AllowedToReadWallClock("It holds the run back to the speed that people want, and says how long the run took.")
final class RunLoop {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final Logger LOG = System.getLogger(RunLoop.class.getName());
    private static final AtomicLong RUNS = new AtomicLong();
    private static final Duration PATIENCE = Duration.ofSeconds(1);
    private static final long LONG_REST = 10_000_000; // [ns], before robots are there and while nobody waits
    private static final Answer ENDED = new Answer.Refused("The run has ended.");

    private static final String BROKEN = "broken";

    private final RunPlan plan;
    private final String name = "run-" + RUNS.incrementAndGet();
    private final Queue<Runnable> commands = new ConcurrentLinkedQueue<>();
    private final CompletableFuture<RunResult> result = new CompletableFuture<>();
    private final Requests requests = // wait until the robots are there
            new Requests(result.handle((_, _) -> ENDED));
    private final Viewers eventViewers = new Viewers();
    private final ExecutorService helpers;
    private final PhaseTimes phaseTimes = new PhaseTimes(System::nanoTime, RunLoop::processorTime);
    private final StepTimes stepTimes = new StepTimes();
    private final Optional<DrivenTime> drivenTime; // by another simulator
    private final Scheduler scheduler;
    private final RunClock clock;
    private final long beganNanos = System.nanoTime();
    private final LongSupplier operatorClock;
    private final EventLog eventLog;
    private final SentGoals goals = new SentGoals(this::elapsed);
    private final MetricsObserver metrics;
    private final Traffic traffic;
    private final Pacer pacer;
    private final Pausing pausing;
    private final SimulatedSteps steps;
    private final Snapshots snapshots;
    private final AgentTurns turns = new AgentTurns();
    private final RunReporter reporter;
    private final Optional<ObserverFeed> observer;
    private final Optional<RobotRecorder> recorder;
    private volatile @Nullable Thread thread;
    private volatile boolean remembers;
    private volatile @Nullable FinalState finalState;

    // of the run's thread
    private @Nullable RunAssembly assembly;
    private @Nullable String outcome;
    private boolean over;

    RunLoop(RunPlan plan, int helpers, LongSupplier operatorClock, RunMonitors monitors) {
        this.plan = plan;
        this.recorder = monitors.recorder();
        this.operatorClock = operatorClock;
        this.helpers = Executors.newFixedThreadPool(
                helpers, Thread.ofPlatform().daemon().name(name + "-helper-", 1).factory());
        this.drivenTime = Optional.of(new DrivenTime(why -> breaksOnItsThread(new RunBroken(why))))
                .filter(_ -> plan.isTimeDriven());
        this.scheduler = switch (plan.clock()) {
            case SIMULATED -> new LockstepScheduler(Instant.EPOCH, this.helpers, phaseTimes);
            case WALL -> new WallScheduler(name, this.helpers, this::breaksOnItsThread, phaseTimes, drivenTime);
        };
        this.clock = new RunClock(scheduler);
        this.eventLog = new EventLog(clock::elapsed, eventViewers::publish, monitors.observer());
        this.metrics = new MetricsObserver(plan, eventLog, clock);
        this.traffic = new Traffic(eventLog, metrics, plan.communication().isPresent());
        this.pacer = new Pacer(System::nanoTime, plan.clock() == RunPlan.Clock.WALL ? 1 : plan.speed());
        this.pausing = new Pausing(
                isSimulated(), scheduler, () -> pacer.restart(elapsed().toNanos()));
        this.steps = new SimulatedSteps(plan.step(), pacer, pausing, stepTimes);
        this.reporter = new RunReporter(pacer, operatorClock);
        this.observer = monitors.observer().map(seen -> new ObserverFeed(seen, reporter, eventLog));
        this.snapshots = new Snapshots(System::nanoTime, sequence -> reporter.snapshot(sequence, progress()));
    }

    /// Starts its thread, and another one that watches over its agents. Once, by the one who made it.
    ///
    /// @param patience after how many seconds of real time an agent counts as one that never returns
    void start(int patience) {
        switch (scheduler) {
            case LockstepScheduler time ->
                Thread.ofPlatform().name(name).daemon().start(() -> simulate(time));
            default -> scheduler.execute(this::begin);
        }
        var watch = new AgentWatch(turns, patience, result, this::giveUp);
        Thread.ofPlatform().name(name + "-watchdog").daemon().start(watch::run);
    }

    RunPlan plan() {
        return plan;
    }

    CompletableFuture<RunResult> result() {
        return result;
    }

    EventLog eventLog() {
        return eventLog;
    }

    Viewers eventViewers() {
        return eventViewers;
    }

    SentGoals goals() {
        return goals;
    }

    Snapshots snapshots() {
        return snapshots;
    }

    /// Real time, by which commands of people are dated [ns]. Any thread may ask.
    long operatorTime() {
        return operatorClock.getAsLong();
    }

    /// Since the run's start, when its robots were there. Any thread may ask.
    Duration elapsed() {
        return clock.elapsed();
    }

    /// Any thread may ask.
    boolean isSimulated() {
        return plan.clock() == RunPlan.Clock.SIMULATED;
    }

    /// What it has counted so far. Any thread may ask.
    Performance performance() {
        return new Performance(
                snapshots.newest().time(),
                stepTimes.soFar(),
                phaseTimes.all(),
                phaseTimes.allOfProcessor(),
                traffic.topics(),
                eventLog.kinds());
    }

    /// Of the thread that asks [ns]; 0 where the machine doesn't tell.
    private static long processorTime() {
        return THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : 0;
    }

    // --- asked by any thread

    void pause() {
        command(pausing::pause);
    }

    void resume() {
        command(pausing::resume);
    }

    void step() {
        command(pausing::step);
    }

    /// Whether and how it is paused. Of the run's thread.
    Pausing pausing() {
        return pausing;
    }

    void speed(double factor) {
        command(() -> pacer.speed(factor, elapsed().toNanos()));
    }

    void stop() {
        command(() -> end(RunEnding.STOPPED));
    }

    void remember(boolean wanted) {
        remembers = wanted;
        if (wanted) {
            eventLog.routine().remember();
        }
    }

    /// Waits for a second at most until the run has ended. Returns at once on the run's own thread.
    void awaitEnd() {
        if (Thread.currentThread().equals(thread)) {
            return;
        }
        try {
            result.handle((_, _) -> true).get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException _) {
            LOG.log(
                    Level.WARNING,
                    "A run does not end. It is busy in {0}; maybe an agent there never returns.",
                    AgentWatch.place(AgentWatch.busyThread(turns).or(() -> Optional.ofNullable(thread))));
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        } catch (ExecutionException e) {
            throw new AssertionError("Both endings are handled.", e);
        }
    }

    /// Has the run do something between two steps, in the name of who [Operator#name] names.
    ///
    /// @return the answer; refused when the run ends before
    CompletionStage<Answer> ask(Function<RunAssembly, Answer> question) {
        String operator = Operator.name();
        CompletionStage<Answer> answer = requests.ask(() -> eventLog.by(operator, () -> answer(question)));
        wake();
        return answer;
    }

    /// @param recalled what is answered once the run has ended, if it remembers that
    CompletionStage<Answer> askOrRecall(Function<RunAssembly, Answer> question, Function<FinalState, Answer> recalled) {
        return ask(question).thenApply(answer -> {
            FinalState last = finalState;
            return last != null && answer.equals(ENDED) ? recalled.apply(last) : answer;
        });
    }

    private void command(Runnable command) {
        commands.add(command);
        wake();
    }

    void wake() {
        if (isSimulated()) {
            LockSupport.unpark(thread);
        } else {
            scheduler.execute(this::serve);
        }
    }

    /// On the thread that watches over the agents.
    private void giveUp(RunBroken broken) {
        LOG.log(Level.ERROR, broken::getMessage);
        commands.add(() -> end(BROKEN)); // if the agent returns after all
        result.completeExceptionally(broken);
    }

    // --- on the run's thread

    private Answer answer(Function<RunAssembly, Answer> question) {
        try {
            return question.apply(Objects.requireNonNull(assembly));
        } catch (IllegalArgumentException e) {
            return new Answer.Refused(String.valueOf(e.getMessage()));
        }
    }

    /// In simulated time: goes on step by step until it is over.
    private void simulate(LockstepScheduler time) {
        try {
            begin();
            while (outcome == null) {
                takeCommands();
                goOn(time);
            }
            finish();
        } catch (RuntimeException | Error e) {
            breaks(e);
        }
    }

    private void begin() {
        thread = Thread.currentThread();
        var everything = new RunAssembly(plan, scheduler, clock, eventLog, metrics, traffic, turns, goals);
        assembly = everything;
        observer.ifPresent(_ -> everything.noteLinks(operatorTime()));
        recorder.ifPresent(everything::recordBy);
        drivenTime.ifPresent(time -> {
            time.onReached(everything::reached);
            everything.onTime(time::set);
        });
        everything.begin();
        scheduler.every(plan.step(), Phase.OBSERVE, () -> {
            if (everything.isReady()) { // else its end would hide that robots can't be reached
                everything.observe().ifPresent(this::end);
                observer.ifPresent(feed -> feed.showIfDue(everything, progress()));
            }
        });
        if (!isSimulated()) {
            scheduler.inRealTime().every(plan.step(), Phase.OBSERVE, this::serve);
        }
    }

    /// In real time: does what is wanted between two tasks.
    private void serve() {
        if (over) {
            return;
        }
        takeCommands();
        if (outcome != null) {
            finish();
        } else {
            snapshots.makeIfDue();
        }
    }

    private void takeCommands() {
        for (Runnable next = commands.poll(); next != null; next = commands.poll()) {
            next.run();
        }
        if (assembly != null && assembly.isReady()) {
            requests.take();
            assembly.beat(operatorTime());
        }
    }

    /// Goes on for a part of a step, or waits until it may.
    private void goOn(LockstepScheduler time) {
        if (outcome != null) {
            return;
        }
        if (pausing.isWaiting()) {
            restWhilePaused(time);
            return;
        }
        long early =
                steps.goOn(time, Objects.requireNonNull(assembly), elapsed().toNanos());
        if (early > 0) {
            rest(early);
        } else {
            snapshots.makeIfDue();
        }
    }

    private void restWhilePaused(LockstepScheduler time) {
        boolean ready = Objects.requireNonNull(assembly).isReady();
        if (!ready) {
            time.runPending(); // by which robots and agents come, who can be asked something meanwhile
        }
        rest(ready ? Long.MAX_VALUE : LONG_REST);
    }

    /// Waits, or makes a snapshot if one is wanted; returns early when there is something to do.
    private void rest(long nanos) {
        if (!snapshots.makeIfDue()) {
            LockSupport.parkNanos(this, Math.min(nanos, snapshots.untilDue()));
        }
    }

    private void end(String how) {
        if (outcome != null) {
            return;
        }
        RunEnding ending = assembly == null
                ? RunEnding.of(how)
                : RunEnding.of(how, plan, assembly, !how.equals(RunEnding.STOPPED));
        outcome = ending.outcome();
        eventLog.event("run", "", ending.words());
    }

    private void finish() {
        observer.ifPresent(feed -> feed.show(progress()));
        snapshots.make();
        RunResult ended = endResult();
        rememberEnd();
        release();
        over = true;
        result.complete(ended);
    }

    private RunResult endResult() {
        goals.close();
        double seconds = (System.nanoTime() - beganNanos) / 1e9;
        return RunReporter.result(plan, String.valueOf(outcome), metrics, seconds, eventLog, assembly);
    }

    /// In real time tasks run on threads of agents, too; these are not to end the run.
    private void breaksOnItsThread(Throwable cause) {
        if (Thread.currentThread().equals(thread)) {
            breaks(cause);
        } else {
            scheduler.execute(() -> breaks(cause));
        }
    }

    /// The run can't go on.
    private void breaks(Throwable cause) {
        if (over) {
            return;
        }
        over = true;
        boolean isFull = RunBroken.lackOfMemory(cause).isPresent();
        if (isFull) {
            dropTasks(); // first of all, as the rest of this needs memory
        }
        var broken = cause instanceof RunBroken known ? known : new RunBroken("The run", cause);
        eventLog.event("fault", "", String.valueOf(broken.getMessage()));
        end(BROKEN);
        List<Runnable> last = isFull // for which a last look would take minutes
                ? List.of(this::release)
                : List.of(snapshots::make, this::rememberEnd, this::release);
        for (Runnable rest : last) {
            try {
                rest.run();
            } catch (RuntimeException | Error e) {
                broken.addSuppressed(e);
            }
        }
        result.completeExceptionally(broken);
    }

    private void rememberEnd() {
        if (!remembers || assembly == null) {
            return;
        }
        try {
            finalState = assembly.lastLook(elapsed(), operatorTime());
        } catch (RuntimeException e) { // of a device or an agent: to look must not change how the run ended
            LOG.log(Level.WARNING, "What was known at the end of the run is not remembered.", e);
        }
    }

    private void dropTasks() {
        if (scheduler instanceof LockstepScheduler time) {
            time.drop();
        }
    }

    /// Frees robots, agents and threads.
    private void release() {
        try {
            if (assembly != null) {
                assembly.close();
            }
        } finally {
            helpers.shutdown();
            if (scheduler instanceof WallScheduler time) {
                time.close();
            }
        }
    }

    private RunReporter.Progress progress() {
        return new RunReporter.Progress(
                elapsed(), pausing.isPaused(), Optional.ofNullable(outcome), Optional.ofNullable(assembly));
    }
}
