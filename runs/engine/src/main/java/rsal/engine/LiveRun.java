package rsal.engine;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Queue;
import java.util.Set;
import java.util.TreeSet;
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
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentType;
import rsal.agent.platform.Turns;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Subscription;
import rsal.model.RobotModels;
import rsal.robot.RobotModel;
import rsal.scenario.RunPlan;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.BridgeProvider;
import rsal.system.CommandTimeout;
import rsal.time.AllowedToReadWallClock;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;
import rsal.time.PhaseTimes;
import rsal.time.Scheduler;
import rsal.time.WallScheduler;

/// A run under way, or ended. All methods may be called from any thread; listeners are called on the run's thread
/// and must be quick.
///
/// The run has a thread of its own, `run-<n>`, and helpers for heavy work, `run-<n>-helper-<m>`. Between two
/// steps it takes commands and makes a snapshot if somebody wants one. How it is watched, paused and paced never
/// changes what happens in it; placing robots, driving them, telling them what to do and the emergency stop do, and are
/// events of the run. A run in real time can't be paused or paced: it goes on at speed 1.
@AllowedToReadWallClock("It holds the run back to the pace that people want to watch, and says how long it took.")
public final class LiveRun implements AutoCloseable {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final Logger LOG = System.getLogger(LiveRun.class.getName());
    private static final AtomicLong RUNS = new AtomicLong();
    private static final Duration PATIENCE = Duration.ofSeconds(1);
    private static final long MOMENT = 500_000; // [ns], after which it looks again whether it may go on
    private static final long WHILE = 10_000_000; // [ns], likewise, before robots are there and while nobody waits
    private static final Duration PERIOD_OF_MINDS = Duration.ofSeconds(1); // of the run
    private static final int AGENTS_MAY_TAKE = 20; // times as long for one turn
    private static final Answer LATE = new Answer.Refused("The run has ended.");

    private static final String STOPPED = "stopped";
    private static final String TIMEOUT = RunPlan.Outcome.TIMEOUT.word();
    private static final String FAILURE = RunPlan.Outcome.FAILURE.word();

    private final RunPlan plan;
    private final Queue<Runnable> commands = new ConcurrentLinkedQueue<>();
    private final CompletableFuture<RunResult> result = new CompletableFuture<>();
    private final Requests requests = // wait until the robots are there
            new Requests(result.handle((_, _) -> LATE));
    private final Viewers eventViewers = new Viewers();
    private final ExecutorService helpers;
    private final PhaseTimes phaseTimes = new PhaseTimes(System::nanoTime, LiveRun::processorTime);
    private final StepTimes stepTimes = new StepTimes();
    private final Scheduler scheduler;
    private final Instant began;
    private final long beganNanos = System.nanoTime();
    private final LongSupplier handClock;
    private final EventLog eventLog;
    private final SentGoals goals = new SentGoals(this::elapsed);
    private final MetricsObserver observer;
    private final Traffic traffic;
    private final Pacer pace;
    private final Snapshots snapshots;
    private final Turns turns = new Turns();
    private final Optional<RunObserver> witness;
    private volatile @Nullable Thread thread;
    private volatile boolean remembers;
    private volatile @Nullable FinalState lastLook;

    // of the run's thread
    private @Nullable RunAssembly stage;
    private @Nullable String outcome;
    private boolean over;
    private boolean paused;
    private int stepsWanted;
    private long witnessed; // how often everything was shown
    private final LinkSampler witnessedLinks = new LinkSampler(); // apart from those who look when they like
    private final LinkSampler seenLinks = new LinkSampler();
    private Duration nextWitnessed = Duration.ZERO;
    private Duration nextMinds = Duration.ZERO;

    private LiveRun(RunPlan plan, String name, int helpers, LongSupplier handClock, Optional<RunObserver> witness) {
        this.plan = plan;
        this.witness = witness;
        this.handClock = handClock;
        this.helpers = Executors.newFixedThreadPool(
                helpers, Thread.ofPlatform().daemon().name(name + "-helper-", 1).factory());
        this.scheduler = switch (plan.clock()) {
            case SIMULATED -> new LockstepScheduler(Instant.EPOCH, this.helpers, phaseTimes);
            case WALL -> new WallScheduler(name, this.helpers, this::breaksOnItsThread, phaseTimes);
        };
        this.began = scheduler.instant();
        this.eventLog = new EventLog(this::elapsed, eventViewers::tell, witness);
        this.observer = new MetricsObserver(plan, eventLog, scheduler);
        this.traffic = new Traffic(eventLog, observer, plan.communication().isPresent());
        this.pace = new Pacer(System::nanoTime, plan.clock() == RunPlan.Clock.WALL ? 1 : plan.speed());
        this.snapshots = new Snapshots(System::nanoTime, sequence -> snapshot(sequence, seenLinks));
    }

    /// Starts a run. Robots and agents are made on its own thread; what goes wrong there ends its [#result].
    public static LiveRun start(RunPlan plan) {
        return start(plan, System::nanoTime);
    }

    /// Starts a run that somebody sees all of. It goes as it would without.
    public static LiveRun start(RunPlan plan, RunObserver witness) {
        return start(plan, usualHelpers(), System::nanoTime, AGENTS_MAY_TAKE, Optional.of(witness));
    }

    /// @param handClock how long hands that drive robots are not heard is measured by [ns]; any thread asks it
    static LiveRun start(RunPlan plan, LongSupplier handClock) {
        return start(plan, usualHelpers(), handClock);
    }

    private static int usualHelpers() {
        return Math.max(1, Runtime.getRuntime().availableProcessors() - 1);
    }

    /// The same beside other runs, which share the cores.
    ///
    /// @param helpers how many threads help the run's own with heavy work
    public static LiveRun start(RunPlan plan, int helpers) {
        return start(plan, helpers, Optional.empty());
    }

    /// @param witness who sees all of it; it goes as it would without
    public static LiveRun start(RunPlan plan, int helpers, Optional<RunObserver> witness) {
        return start(plan, helpers, System::nanoTime, AGENTS_MAY_TAKE, witness);
    }

    private static LiveRun start(RunPlan plan, int helpers, LongSupplier handClock) {
        return start(plan, helpers, handClock, AGENTS_MAY_TAKE);
    }

    /// @param patience after how many seconds of real time an agent counts as one that never returns
    static LiveRun start(RunPlan plan, int helpers, LongSupplier handClock, int patience) {
        return start(plan, helpers, handClock, patience, Optional.empty());
    }

    private static LiveRun start(
            RunPlan plan, int helpers, LongSupplier handClock, int patience, Optional<RunObserver> witness) {
        String name = "run-" + RUNS.incrementAndGet();
        var run = new LiveRun(plan, name, helpers, handClock, witness);
        switch (run.scheduler) {
            case LockstepScheduler time ->
                Thread.ofPlatform().name(name).daemon().start(() -> run.simulate(time));
            default -> run.scheduler.execute(run::begin);
        }
        Thread.ofPlatform().name(name + "-watchdog").daemon().start(() -> run.watch(patience));
        return run;
    }

    public RunPlan plan() {
        return plan;
    }

    /// Completes once, on the run's thread, when the run has ended and let go of everything; exceptionally with
    /// [RunBroken] when it could not go on. On another thread, and before it has let go of anything, when an agent
    /// never returns.
    public CompletionStage<RunResult> result() {
        return result.minimalCompletionStage();
    }

    /// Lets time stand still.
    public void pause() {
        command(() -> paused = isSimulated());
    }

    public void resume() {
        command(() -> {
            paused = false;
            pace.restart(elapsed().toNanos());
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
        if (isSimulated()) {
            command(() -> pace.speed(factor, elapsed().toNanos()));
        }
    }

    private boolean isSimulated() {
        return plan.clock() == RunPlan.Clock.SIMULATED;
    }

    /// Ends the run with the outcome `stopped`.
    public void stop() {
        command(() -> end(STOPPED));
    }

    /// Puts a robot somewhere: in the simulated world, if there is one, and in its localizer's belief. Or a thing of
    /// the simulated world.
    public CompletionStage<Answer> place(String entity, Pose2d mapFromEntity) {
        return ask(stage -> stage.world().place(entity, mapFromEntity));
    }

    /// Tells a robot's localizer where it is. The robot stays where it truly is, which its localizer may find out.
    public CompletionStage<Answer> believe(String robot, Pose2d mapFromBase) {
        return ask(stage -> stage.world().believe(robot, mapFromBase));
    }

    /// Puts something new into the simulated world.
    ///
    /// @return [Answer.Added] when it is there
    public CompletionStage<Answer> add(PlacedThing prop, Pose2d mapFromThing) {
        return ask(stage -> stage.world().add(prop, mapFromThing));
    }

    /// Puts another robot into the simulated world, with devices and agents like those of one that is or was there.
    ///
    /// @return [Answer.Added] when it is there
    public CompletionStage<Answer> addRobot(String like, Pose2d mapFromBase) {
        return ask(stage -> stage.world().addRobot(like, mapFromBase));
    }

    /// Puts a robot of one of the [#robotModels] into the simulated world. It is named after its model, and has no
    /// agents.
    ///
    /// @return [Answer.Added] when it is there
    public CompletionStage<Answer> newRobot(String model, Pose2d mapFromBase) {
        return ask(stage -> stage.world().newRobot(model, mapFromBase));
    }

    /// Models of robots that people can add: the same in all runs.
    public static List<RobotModel> robotModels() {
        var models = new RobotModels(FileSource.resources(LiveRun.class, "/"));
        return RobotModels.builtIn().stream()
                .map(name -> models.read(name, Location.of(name)))
                .toList();
    }

    /// Takes a robot with its agents, or a thing, out of the simulated world.
    public CompletionStage<Answer> remove(String entity) {
        return ask(stage -> stage.world().remove(entity));
    }

    /// To which places people sent robots, oldest first; of those that ended the last 200. Any thread may ask.
    public List<SentGoal> goals() {
        return goals.all();
    }

    /// Has a robot drive somewhere, by its agent if that can. Answers with [Answer.Sent].
    public CompletionStage<Answer> goTo(String robot, Pose2d mapFromGoal) {
        long now = handClock.getAsLong();
        return ask(stage -> stage.orders().goTo(robot, mapFromGoal, now));
    }

    /// Has a robot do something until it is told something else.
    ///
    /// @param behavior one of [rsal.behavior.Repertoire], `stand`, or empty to leave it to its agents again
    public CompletionStage<Answer> behave(String robot, String behavior) {
        long now = handClock.getAsLong();
        return ask(stage -> stage.orders().behave(robot, behavior, now));
    }

    /// What a robot can be told to do, as [Answer.Able].
    public CompletionStage<Answer> abilities(String robot) {
        return ask(stage -> stage.orders().abilities(robot));
    }

    /// What a robot's devices have told last, as [Answer.Read]; nothing of one that is gone, or from where it was
    /// before it was placed elsewhere.
    public CompletionStage<Answer> readings(String robot) {
        return askOrRecall(stage -> stage.readings(robot, elapsed()), last -> last.readings(robot));
    }

    /// What places cost a robot's navigator, as [Answer.Costed].
    public CompletionStage<Answer> costs(String robot) {
        return ask(stage -> stage.costs(robot));
    }

    /// Who heard what so far, as [Answer.Heard]; afterwards the result tells, too.
    public CompletionStage<Answer> communication() {
        return askOrRecall(stage -> new Answer.Heard(stage.hearings()), FinalState::communication);
    }

    /// How much was said so far, and what became of it, as [Answer.Counted]; afterwards the result tells, too.
    public CompletionStage<Answer> topics() {
        return askOrRecall(stage -> new Answer.Counted(stage.topics()), FinalState::topics);
    }

    /// What agents say so often that it is no event each time, as where they are: see [Answer.Repeated].
    ///
    /// @param topic of which all is told; of the others, that they are there
    public CompletionStage<Answer> routine(String topic) {
        return askOrRecall(
                stage -> new Answer.Repeated(stage.routine().of(topic)),
                last -> new Answer.Repeated(last.routine().of(topic)));
    }

    /// The same of what was said by a time: not long before it, or as far back as is needed to know of each agent what
    /// it had said last. Runs that [remember][#remember] know of more.
    ///
    /// @param until since the run's start
    /// @param shortly how long before that, where that is enough
    public CompletionStage<Answer> routine(String topic, Duration until, Duration shortly) {
        return askOrRecall(
                stage -> new Answer.Repeated(stage.routine().of(topic, until, shortly)),
                last -> new Answer.Repeated(last.routine().of(topic, until, shortly)));
    }

    /// What an agent believes, wants and says now, as [Answer.Seen]. Looking changes nothing in the run, but costs it a
    /// little for the seconds after: what changes in the agent meanwhile is noted at each step.
    public CompletionStage<Answer> inside(String agent) {
        return askOrRecall(stage -> stage.inside(agent, handClock.getAsLong()), last -> last.agent(agent));
    }

    /// What some agents believe and want now, as [Answer.Minded]; nothing of those that don't run, or don't show it.
    public CompletionStage<Answer> minds(List<String> agents) {
        return ask(stage -> new Answer.Minded(elapsed(), stage.minds(agents)));
    }

    /// Which robots' agents hear each other now, as [Answer.Linked]. Looking changes nothing in the run, but costs
    /// it a little for the seconds after: what is heard meanwhile is noted. So it is while snapshots are made of a
    /// run of at most 50 robots.
    ///
    /// @param chosen the robot whose links are told when there are more than 50 robots; empty, or unknown, for none
    public CompletionStage<Answer> links(String chosen) {
        long now = handClock.getAsLong();
        return ask(stage -> stage.links(chosen, now));
    }

    /// Starts another agent like one that is or was there, with its type and arguments.
    ///
    /// @param robot that it is to act for; empty when the other one has none
    /// @return [Answer.Added] when it runs
    public CompletionStage<Answer> addAgent(String like, String robot) {
        return ask(stage -> stage.addAgent(like, robot));
    }

    /// Starts an agent again that has ended or failed.
    public CompletionStage<Answer> startAgent(String name) {
        return ask(stage -> stage.startAgent(name));
    }

    /// Ends an agent, as it would at the end of the run.
    public CompletionStage<Answer> stopAgent(String name) {
        return ask(stage -> stage.stopAgent(name));
    }

    /// Says something to agents in the operator's name. The radio carries it as it does what agents without a robot
    /// say.
    ///
    /// @param to name of an agent; empty for all who listen
    /// @param topic name of one in [#sayable]
    /// @param typed what a person typed, by name of the field
    public CompletionStage<Answer> say(String to, String topic, Map<String, String> typed) {
        return ask(stage -> stage.say(to, topic, typed));
    }

    /// Starts an agent of a type that is installed, as people want it. It is named after its type.
    ///
    /// @param robot id of the one that it is to act for; empty for none
    /// @param typed its arguments, as somebody typed them; those that are left out are as the type has them
    /// @return [Answer.Added] with its name
    public CompletionStage<Answer> newAgent(String type, String robot, Map<String, String> typed) {
        return ask(stage -> stage.newAgent(type, robot, typed));
    }

    /// Types of agents that people can start: the same in all runs.
    ///
    /// @throws InvalidSettings when one of them can't be loaded
    public static List<AgentType> agentTypes() {
        return List.copyOf(TypedAgent.types().values());
    }

    /// What people can say: the same in all runs.
    public static List<OperatorMessage> sayable() {
        return OperatorMessages.ALL;
    }

    /// Offers the robots to others, until the run ends, those that come later, too. Who has them over the bridge drives
    /// them like their agents: what people want comes first.
    ///
    /// @param at where to listen: at this port, and those after it if need be; port 0 for any that are free
    /// @return [Answer.Bridged] when it is open
    public CompletionStage<Answer> bridge(BridgeProvider provider, InetSocketAddress at) {
        return bridge(provider, at, Optional.of(CommandTimeout.USUAL));
    }

    /// Likewise.
    ///
    /// @param silence for how long robots are driven on when no command comes from a client any more, in real time;
    /// empty for clients that command once
    public CompletionStage<Answer> bridge(BridgeProvider provider, InetSocketAddress at, Optional<Duration> silence) {
        return ask(stage -> stage.bridge(provider, at, new CommandTimeout(silence, handClock)));
    }

    /// Drives a robot by hand, instead of whoever else would, until [#letGo]. Must be said again and again: the robot
    /// stands still when it was not for half a second of real time, and is given back after five.
    ///
    /// @param driver who that is; as long as one drives, no other can
    /// @param velocity wanted now; the base makes of it what it can
    public CompletionStage<Answer> drive(String robot, String driver, Twist2d velocity) {
        long now = handClock.getAsLong();
        return ask(stage -> stage.orders().drive(robot, driver, velocity, now));
    }

    /// Gives a robot back to its agents that was driven by hand.
    public CompletionStage<Answer> letGo(String robot, String driver) {
        return ask(stage -> stage.orders().letGo(robot, driver));
    }

    /// Switches off all motors, until [#rearm].
    public CompletionStage<Answer> estop() {
        return ask(stage -> stage.orders().stop());
    }

    /// Ends the emergency stop. Who was switched off by [#stop(String)] stays off, and is named by [Answer.Armed].
    public CompletionStage<Answer> rearm() {
        return ask(stage -> stage.orders().rearm());
    }

    /// Switches the motors of one robot off, until [#rearm(String)].
    public CompletionStage<Answer> stop(String robot) {
        return ask(stage -> stage.orders().stop(robot, true));
    }

    /// Switches them on, also while those of the others stay off after an emergency stop.
    public CompletionStage<Answer> rearm(String robot) {
        return ask(stage -> stage.orders().stop(robot, false));
    }

    /// The newest there is. Asking for it asks for a newer one, too.
    public Snapshot snapshot() {
        snapshots.want();
        wake();
        return snapshots.newest();
    }

    /// How the run is now: a snapshot that is made after this was asked, as the newest may be of long ago. Completes on
    /// the run's thread; when the run is over, at once with its last.
    public CompletionStage<Snapshot> freshSnapshot() {
        if (result.isDone()) {
            return CompletableFuture.completedFuture(snapshots.newest());
        }
        var fresh = new CompletableFuture<Snapshot>();
        Subscription looking = onSnapshot(() -> fresh.complete(snapshots.newest()));
        snapshot(); // asks for one
        return fresh.whenComplete((_, _) -> looking.cancel());
    }

    /// Tells when there is a new snapshot. A listener that throws is told no more.
    public Subscription onSnapshot(Runnable listener) {
        return snapshots.viewers().add(listener);
    }

    /// What has happened after an event, oldest first.
    ///
    /// @param sequence of that event; 0 for all
    public List<RunEvent> events(long sequence) {
        return eventLog.after(sequence);
    }

    /// What it has counted so far; also when it has ended. Never waits for the run.
    public Metrics metrics() {
        var phases = new EnumMap<Phase, Duration>(Phase.class);
        var processors = new EnumMap<Phase, Duration>(Phase.class);
        for (Phase phase : Phase.values()) {
            phases.put(phase, phaseTimes.of(phase));
            processors.put(phase, phaseTimes.processor(phase));
        }
        return new Metrics(
                snapshot().time(), stepTimes.soFar(), phases, processors, traffic.topics(), eventLog.kinds());
    }

    /// Of the thread that asks [ns]; 0 where the machine doesn't tell.
    private static long processorTime() {
        return THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : 0;
    }

    /// Tells when there is a new event. A listener that throws is told no more.
    public Subscription onEvents(Runnable listener) {
        return eventViewers.add(listener);
    }

    /// Has the run remember what was said all the time, in 16 MB; and, once it ends, what [#readings], [#inside],
    /// [#routine], [#topics] and [#communication] answered then: they go on answering that. Otherwise they are
    /// refused when it is over. One that ends for lack of memory remembers nothing.
    public void remember() {
        remembers = true;
        eventLog.routine().remember();
    }

    /// Ends the run, if it has not ended, and waits up to a second until it has.
    @Override
    public void close() {
        remembers = false; // nobody looks at it any more
        stop();
        if (Thread.currentThread().equals(thread)) {
            return;
        }
        try {
            result.handle((_, _) -> true).get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException _) {
            LOG.log(
                    Level.WARNING,
                    "A run does not end. It is busy in {0}; maybe an agent there never returns.",
                    place(busyThread()));
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        } catch (ExecutionException e) {
            throw new AssertionError("Both endings are handled.", e);
        }
    }

    /// Looks again and again, until the run is over, whether all agents return.
    private void watch(int patience) {
        var watchdog = new Watchdog(turns, patience);
        CompletableFuture<Boolean> ending = result.handle((_, _) -> true);
        while (!ending.isDone()) {
            try {
                ending.get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
            } catch (TimeoutException _) {
                look(watchdog, patience);
            } catch (InterruptedException | ExecutionException e) {
                throw new AssertionError("Nobody interrupts it, and both endings are handled.", e);
            }
        }
    }

    private void look(Watchdog watchdog, int patience) {
        try {
            watchdog.look().ifPresent(agent -> giveUp(agent, patience));
        } catch (OutOfMemoryError _) {
            // what the run does about it is its own matter; the next look may have enough
        }
    }

    private void giveUp(String agent, int seconds) {
        var broken = new RunBroken(
                "Agent (%s) has not returned for %d s; it is in %s. Nothing in an agent may block: maybe use its scheduler, or a CompletionStage."
                        .formatted(agent, seconds, place(turns.thread(agent))));
        LOG.log(Level.ERROR, broken::getMessage);
        commands.add(() -> end("broken")); // if it returns after all
        result.completeExceptionally(broken);
    }

    /// That of an agent at work, as hosts may have threads of their own; the run's else.
    private Optional<Thread> busyThread() {
        return turns.underWay().keySet().stream()
                .findFirst()
                .flatMap(turns::thread)
                .or(() -> Optional.ofNullable(thread));
    }

    /// Where a thread is, beside what Java itself does there.
    private static String place(Optional<Thread> busy) {
        return busy.map(Thread::getStackTrace).stream()
                .flatMap(Arrays::stream)
                .filter(frame -> !frame.getClassName().matches("(java|javax|jdk|sun)\\..*"))
                .findFirst()
                .map(StackTraceElement::toString)
                .orElse("nothing");
    }

    private void command(Runnable command) {
        commands.add(command);
        wake();
    }

    private void wake() {
        if (isSimulated()) {
            LockSupport.unpark(thread);
        } else {
            scheduler.execute(this::serve);
        }
    }

    private CompletionStage<Answer> ask(Function<RunAssembly, Answer> order) {
        String operator = Operator.name();
        CompletionStage<Answer> answer = requests.ask(() -> eventLog.by(operator, () -> answer(order)));
        wake();
        return answer;
    }

    /// @param recalled what is answered once the run has ended, if it remembers that
    private CompletionStage<Answer> askOrRecall(
            Function<RunAssembly, Answer> order, Function<FinalState, Answer> recalled) {
        return ask(order).thenApply(answer -> {
            FinalState last = lastLook;
            return last != null && answer.equals(LATE) ? recalled.apply(last) : answer;
        });
    }

    private Answer answer(Function<RunAssembly, Answer> order) {
        try {
            return order.apply(Objects.requireNonNull(stage));
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
        var everything = new RunAssembly(plan, scheduler, eventLog, observer, traffic, turns, goals);
        stage = everything;
        witness.ifPresent(_ -> everything.noteLinks(handClock.getAsLong()));
        everything.begin();
        scheduler.every(plan.step(), Phase.OBSERVE, () -> {
            if (everything.isReady()) { // else its end would hide that robots can't be reached
                everything.observe().ifPresent(this::end);
                witness.ifPresent(seen -> showIfDue(seen, everything));
            }
            if (!isSimulated()) {
                serve();
            }
        });
    }

    private void showIfDue(RunObserver seen, RunAssembly everything) {
        Duration now = elapsed();
        if (now.compareTo(nextMinds) >= 0) {
            nextMinds = now.plus(PERIOD_OF_MINDS);
            seen.looksInto(now, everything.minds());
        }
        if (now.compareTo(nextWitnessed) >= 0) {
            nextWitnessed = nextWitnessed.plus(seen.period());
            if (nextWitnessed.compareTo(now) <= 0) { // real time may have gone on
                nextWitnessed = now.plus(seen.period());
            }
            if (seen.looks()) {
                seen.sees(snapshot(witnessed++, witnessedLinks), eventLog.hashSoFar());
            }
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
        if (stage != null && stage.isReady()) {
            requests.take();
            stage.beat(handClock.getAsLong());
        }
    }

    /// Goes on for a step, or waits until it may.
    private void goOn(LockstepScheduler time) {
        if (outcome != null) {
            return;
        }
        if (paused && stepsWanted == 0) {
            boolean ready = Objects.requireNonNull(stage).isReady();
            if (!ready) {
                time.runPending(); // by which robots and agents come, who can be asked something meanwhile
            }
            rest(ready ? Long.MAX_VALUE : WHILE);
            return;
        }
        long early = paused ? 0 : pace.early(elapsed().toNanos());
        if (early > 0) {
            rest(early);
            return;
        }
        if (pace.isAhead(elapsed().toNanos()) && Objects.requireNonNull(stage).isAwaited()) {
            time.runPending(); // what such a program asks meanwhile
            rest(MOMENT);
            return;
        }
        stepsWanted = Math.max(0, stepsWanted - 1);
        long from = System.nanoTime();
        time.advance(plan.step());
        stepTimes.took(System.nanoTime() - from);
        snapshots.makeIfDue();
    }

    /// Waits, or makes a snapshot if one is wanted; returns early when there is something to do.
    private void rest(long nanos) {
        if (!snapshots.makeIfDue()) {
            LockSupport.parkNanos(this, Math.min(nanos, snapshots.untilDue()));
        }
    }

    private void end(String how) {
        if (outcome == null) {
            Set<String> failed = stage == null || plan.toleratesFailedAgents() || how.equals(STOPPED)
                    ? Set.of()
                    : Stream.of(
                                    stage.failedAgents().keySet(),
                                    stage.unhandledGoals().keySet())
                            .flatMap(Set::stream)
                            .collect(Collectors.toCollection(TreeSet::new));
            outcome = failed.isEmpty() || how.equals(TIMEOUT) ? how : FAILURE;
            String why = failed.isEmpty() ? "" : "; failed: " + String.join(", ", failed);
            eventLog.event("run", "", "ends: " + outcome + why);
        }
    }

    private void finish() {
        witness.filter(RunObserver::looks)
                .ifPresent(seen -> seen.sees(snapshot(witnessed++, witnessedLinks), eventLog.hashSoFar()));
        snapshots.make();
        RunResult ended = result(String.valueOf(outcome), (System.nanoTime() - beganNanos) / 1e9);
        rememberItsEnd();
        letGo();
        over = true;
        result.complete(ended);
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
        end("broken");
        List<Runnable> last = isFull // for which a last look would take minutes
                ? List.of(this::letGo)
                : List.of(snapshots::make, this::rememberItsEnd, this::letGo);
        for (Runnable rest : last) {
            try {
                rest.run();
            } catch (RuntimeException | Error e) {
                broken.addSuppressed(e);
            }
        }
        result.completeExceptionally(broken);
    }

    private void rememberItsEnd() {
        if (!remembers || stage == null) {
            return;
        }
        try {
            lastLook = stage.lastLook(elapsed(), handClock.getAsLong());
        } catch (RuntimeException e) { // of a device or an agent: to look must not change how the run ended
            LOG.log(Level.WARNING, "What was known at the end of the run is not remembered.", e);
        }
    }

    private void dropTasks() {
        if (scheduler instanceof LockstepScheduler time) {
            time.drop();
        }
    }

    private void letGo() {
        try {
            if (stage != null) {
                stage.close();
            }
        } finally {
            helpers.shutdown();
            if (scheduler instanceof WallScheduler time) {
                time.close();
            }
        }
    }

    private RunResult result(String how, double wallSeconds) {
        goals.close();
        var measures = new LinkedHashMap<String, OptionalDouble>();
        var outOfBounds = new ArrayList<String>();
        for (MetricsObserver.Finding finding : observer.findings()) {
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
                eventLog.finish(),
                measures,
                outOfBounds,
                stage == null ? Map.of() : stage.poses(),
                stage == null ? Map.of() : stage.failedAgents(),
                stage == null ? Map.of() : stage.unhandledGoals(),
                stage == null ? List.of() : stage.topics(),
                stage == null ? List.of() : stage.hearings());
    }

    /// @param links that whoever looks was shown before
    private Snapshot snapshot(long sequence, LinkSampler links) {
        return new Snapshot(
                sequence,
                elapsed(),
                paused,
                stage != null && stage.orders().stopped(),
                pace.speed(),
                paused ? 0 : pace.rate(elapsed().toNanos()),
                Optional.ofNullable(outcome),
                stage == null ? List.of() : stage.robotViews(),
                stage == null ? List.of() : stage.agentViews(),
                stage == null ? List.of() : stage.team(),
                stage == null ? List.of() : stage.world().things(),
                Optional.ofNullable(stage)
                        .map(all -> links.at(elapsed(), () -> all.links("", handClock.getAsLong())))
                        .orElse(Answer.Linked.NONE));
    }

    private Duration elapsed() {
        return Duration.between(began, scheduler.instant());
    }
}
