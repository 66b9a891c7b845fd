package rsal.agent.platform;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentSpec;
import rsal.agent.Blackboard;
import rsal.agent.Directory;
import rsal.agent.Interest;
import rsal.agent.Message;
import rsal.agent.OutsideAgent;
import rsal.agent.OutsideCode;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Sensor;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.settings.OwnCode;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// One agent's life and the fence around it: all code of the agent runs inside [#act], so that what it throws
/// ends this agent alone, and its end takes with it whatever it listens to, has scheduled and holds.
///
/// Longer than 500 lines, since each method of [AgentContext] is fenced here, and nowhere else.
final class AgentRuntime implements AgentContext {
    /// How many messages and tasks an agent may set off within [#WINDOW], answers to what it says to one included.
    /// A run with two agents that answer each other for ever would never see the next instant.
    static final int LIMIT = 10_000;
    private static final int MOST_METRIC_NAME = 100; // characters

    /// How many answers to something that an agent says to another alone count for the one who asked, as long as
    /// they come before the end of the next [#WINDOW]. So nobody is ended for what others ask it, and none has to
    /// pay for what it did not set off.
    private static final int ANSWERS = 4;

    private static final Duration LAST_WORDS = Duration.ofSeconds(2); // for one whose code runs elsewhere
    private static final Duration WINDOW = Duration.ofMillis(100);
    private static final Logger LOG = System.getLogger(Agent.class.getName());

    private final AgentPlatform platform;
    private final AgentSpec spec;
    private final Directory.Entry entry;
    private final Scheduler hostLane;
    private final boolean isOnRunsLane;
    private final Scheduler lane = new AgentScheduler();
    private final Directory directory = new Others();
    private final AgentTurns.Turn turn;
    private final RandomGenerator random;
    private final Blackboard blackboard;
    private final Map<String, String> beliefs = new LinkedHashMap<>();
    private final Map<Class<?>, Supplier<?>> views = new HashMap<>(); // for those who look
    private final Set<Subscription> held = new LinkedHashSet<>();
    private @Nullable Agent agent;
    private @Nullable CompletableFuture<Runnable> lastWords; // of one that was stopped
    private AgentPlatform.Status status = AgentPlatform.Status.RUNNING;
    private String state = "";
    private long sent;
    private @Nullable Message<?> drawnFor; // the newest message
    private List<Duration> copies = List.of(); // of that one
    private @Nullable Arrival arrival; // of that one, when it is not one copy at once
    private @Nullable Message<?> lastHeard;
    private Instant windowEnd = Instant.MIN;
    private int setOff;
    private Map<String, Integer> answers = new HashMap<>(); // that others may still give at its expense, by agent
    private Map<String, Integer> answersBefore = Map.of(); // in the window before

    AgentRuntime(AgentPlatform platform, AgentSpec spec, Scheduler hostLane) {
        this.platform = platform;
        this.spec = spec;
        this.hostLane = hostLane;
        this.isOnRunsLane = platform.runs(hostLane);
        this.turn = platform.turns().of(spec.name());
        this.random = new SplittableRandom(spec.seed());
        this.blackboard = new Blackboard(hostLane);
        this.entry = new Directory.Entry(
                spec.name(),
                spec.role(),
                spec.type().key(),
                spec.robot().map(Robot::id).orElse(""),
                spec.robot().map(Robot::role).orElse(""));
    }

    Directory.Entry entry() {
        return entry;
    }

    AgentPlatform.Status status() {
        return status;
    }

    AgentPlatform.View view() {
        return new AgentPlatform.View(entry, status, state, beliefs, sent);
    }

    void start() {
        lane.execute(() -> {
            agent = spec.type().create(spec.arguments());
            agent.start(this);
        });
    }

    void stop() {
        Agent leaving = agent;
        agent = null; // its last words may make somebody stop it again
        if (leaving != null) {
            act(leaving, this::stop);
        }
        if (lastWords == null && status == AgentPlatform.Status.RUNNING) {
            end(AgentPlatform.Status.ENDED, "");
        }
    }

    private void stop(Agent leaving) {
        if (!(leaving instanceof OutsideAgent outside)) {
            leaving.stop(this);
            return;
        }
        CompletableFuture<Runnable> words = outside.lastWords(this).toCompletableFuture();
        if (words.isDone()) {
            words.join().run();
            return;
        }
        lastWords = words;
        var _ = words.whenComplete((_, _) -> hostLane.execute(this::leave));
        hostLane.after(LAST_WORDS, this::leave);
    }

    /// What it still has to say after it was stopped; empty when that is nothing, or was said.
    Optional<CompletableFuture<Runnable>> lastWords() {
        return Optional.ofNullable(lastWords);
    }

    /// Ends one that was stopped, with the last words that are there.
    void leave() {
        CompletableFuture<Runnable> words = lastWords;
        if (words == null) {
            return;
        }
        lastWords = null;
        act(words, said -> said.getNow(() -> {}).run());
        if (status == AgentPlatform.Status.RUNNING) {
            end(AgentPlatform.Status.ENDED, "");
        }
    }

    /// Runs code of the agent if it still lives.
    private <T> void act(T value, Consumer<? super T> code) {
        if (status != AgentPlatform.Status.RUNNING) {
            return;
        }
        boolean begins = turn.begin();
        try {
            code.accept(value);
        } catch (RuntimeException | StackOverflowError | AssertionError | LinkageError e) {
            fail(e);
        } finally {
            if (begins) {
                turn.end();
            }
        }
    }

    /// Refuses what is called from a thread of the agent's own. That thread may keep to itself what it is thrown, so
    /// the agent is ended on its lane as well.
    ///
    /// @param call name of it
    private void onLane(String call) {
        if (!turn.isHere()) {
            var misuse = new IllegalStateException(
                    "Agent '%s' called '%s' on thread '%s' instead of its own, so runs with the same seed would differ. Maybe call it by self.scheduler().execute(() -> ...)."
                            .formatted(name(), call, Thread.currentThread().getName()));
            hostLane.execute(() -> act(misuse, thrown -> {
                throw thrown;
            }));
            throw misuse;
        }
    }

    private void fail(Throwable cause) {
        if (status == AgentPlatform.Status.RUNNING) {
            LOG.log(Level.ERROR, () -> "Agent '%s' failed and is ended.".formatted(name()), cause);
            state = OwnCode.words(cause);
            end(AgentPlatform.Status.FAILED, state);
        }
    }

    private void end(AgentPlatform.Status how, String reason) {
        status = how;
        lastWords = null;
        List.copyOf(held).reversed().forEach(this::letGo);
        if (how == AgentPlatform.Status.FAILED) {
            spec.robot()
                    .flatMap(robot -> robot.find(DriveBase.class))
                    .ifPresent(base -> letGo(() -> base.command(Twist2d.STOP)));
        }
        platform.went(this, reason);
    }

    private void letGo(Subscription subscription) {
        try {
            subscription.cancel();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, () -> "Agent '%s' could not release something.".formatted(name()), e);
        }
    }

    private void countWhatItSetsOff() {
        passOn();
        if (++setOff > LIMIT) {
            throw new IllegalStateException(
                    "Agent '%s' caused more than %d messages, replies and tasks within %d ms, which would stop the run."
                            .formatted(name(), LIMIT, WINDOW.toMillis()));
        }
    }

    /// To the window of now.
    private void passOn() {
        Instant now = hostLane.instant();
        if (!now.isBefore(windowEnd)) {
            answersBefore = now.isBefore(windowEnd.plus(WINDOW)) ? answers : Map.of();
            answers = new HashMap<>();
            windowEnd = now.plus(WINDOW);
            setOff = 0;
        }
    }

    /// Whether another says something to this agent at this one's expense: it has been asked. Goes on to be so
    /// when this one has ended, as what it has asked may still be heard.
    private boolean paysFor(String other) {
        passOn();
        if (!take(answersBefore, other) && !take(answers, other)) {
            return false;
        }
        act(other, _ -> countWhatItSetsOff());
        return true;
    }

    private static boolean take(Map<String, Integer> answers, String other) {
        int left = answers.getOrDefault(other, 0);
        if (left > 0) {
            answers.put(other, left - 1);
        }
        return left > 0;
    }

    @Override
    public String name() {
        return spec.name();
    }

    @Override
    public String role() {
        return spec.role();
    }

    @Override
    public Optional<Robot> robot() {
        onLane("robot");
        return spec.robot();
    }

    @Override
    public Scheduler scheduler() {
        return lane;
    }

    @Override
    public RandomGenerator random() {
        onLane("random");
        return random;
    }

    @Override
    public <M> void publish(Topic<M> topic, M message) {
        onLane("publish");
        if (status == AgentPlatform.Status.RUNNING) {
            countWhatItSetsOff();
            sent++;
            platform.publish(name(), topic, message);
        }
    }

    @Override
    public <M> void send(String to, Topic<M> topic, M message) {
        onLane("send");
        if (status == AgentPlatform.Status.RUNNING) {
            if (platform.member(to).filter(asker -> asker.paysFor(name())).isEmpty()) {
                countWhatItSetsOff();
                answers.merge(to, ANSWERS, (before, more) -> Math.min(before + more, LIMIT));
            }
            sent++;
            platform.send(name(), to, topic, message);
        }
    }

    @Override
    public <M> Subscription subscribe(Topic<M> topic, Interest<M> interest, Consumer<? super Message<M>> listener) {
        onLane("subscribe");
        return new MessageListener<>(interest, listener).listenTo(ear -> platform.listen(topic, name(), ear));
    }

    /// The same for all of this agent's listeners.
    @SuppressWarnings("ReferenceEquality") // two may say the same
    private void draw(Message<?> message) {
        if (drawnFor != message) {
            drawnFor = message;
            copies = platform.copies(message, name());
            arrival = null;
        }
    }

    /// A message of which one copy comes, at once: told once however many listeners this agent has, whose turns are one
    /// after the other.
    @SuppressWarnings("ReferenceEquality") // two may say the same
    private void note(Message<?> message) {
        if (lastHeard != message) {
            lastHeard = message;
            platform.heard(message, name());
        }
    }

    /// What this agent hears of a message of which copies come late.
    private final class Arrival {
        private final Message<?> message;
        private boolean heard;
        private int onTheirWay; // to any of its ears

        Arrival(Message<?> message) {
            this.message = message;
        }

        void note() {
            if (!heard) {
                heard = true;
                platform.heard(message, name());
            }
        }

        /// A copy came late and did not reach it. When that was the last and none has, it has not heard it.
        void noteInVain() {
            if (onTheirWay == 0 && !heard) {
                platform.unheard(message, name());
            }
        }
    }

    @Override
    public <T> Subscription subscribe(Sensor<T> sensor, Consumer<? super Stamped<T>> listener) {
        onLane("subscribe");
        return new AgentListener<Stamped<T>>(listener) {
            @Override
            public void accept(Stamped<T> reading) {
                hostLane.after(Duration.ZERO, Phase.THINK, () -> hear(reading));
            }
        }.listenTo(sensor::subscribe);
    }

    @Override
    public Directory directory() {
        onLane("directory");
        return directory;
    }

    @Override
    public Subscription offer(ServiceDescription capability) {
        onLane("offer");
        if (status != AgentPlatform.Status.RUNNING) {
            return () -> {};
        }
        countWhatItSetsOff();
        platform.offer(entry, capability);
        return () -> {
            onLane("cancel");
            platform.withdraw(entry, capability);
        };
    }

    @Override
    public Blackboard blackboard() {
        onLane("blackboard");
        return blackboard;
    }

    @Override
    public Optional<SimulationControl> simulation() {
        onLane("simulation");
        return platform.simulation();
    }

    @Override
    public void state(String words) {
        onLane("state");
        if (status == AgentPlatform.Status.RUNNING && !words.equals(state)) {
            state = words;
            platform.changed(this);
        }
    }

    @Override
    public void print(String line) {
        onLane("print");
        if (status == AgentPlatform.Status.RUNNING) {
            state = line;
            platform.printed(new AgentPlatform.Print(name(), line));
        }
    }

    @Override
    public void metric(String name, double value) {
        onLane("metric");
        if (name.isEmpty() || name.length() > MOST_METRIC_NAME || !Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    "A metric has a name of 1 to %d characters and a finite value, not '%s' and %s."
                            .formatted(MOST_METRIC_NAME, name, value));
        }
        if (status == AgentPlatform.Status.RUNNING) {
            countWhatItSetsOff();
            platform.measured(new AgentPlatform.Metric(name(), name, value));
        }
    }

    @Override
    public void unhandled(String goal, String where) {
        onLane("unhandled");
        platform.unhandled(new AgentPlatform.Unhandled(name(), goal, where));
    }

    @Override
    public void show(String name, String belief) {
        onLane("show");
        beliefs.put(name, belief);
    }

    @Override
    public <T> void reveal(Class<T> type, Supplier<? extends T> view) {
        onLane("reveal");
        views.put(type, view);
    }

    /// What it reveals of a type now; empty when that is nothing, or when it does not run.
    <T> Optional<T> look(Class<T> type) {
        Supplier<?> view = status == AgentPlatform.Status.RUNNING ? views.get(type) : null;
        if (view == null) {
            return Optional.empty();
        }
        boolean begins = turn.begin();
        try {
            return Optional.of(type.cast(view.get()));
        } catch (RuntimeException | StackOverflowError | AssertionError | LinkageError e) {
            throw new IllegalArgumentException(
                    "Agent '%s' can't be inspected: %s".formatted(name(), e.getMessage()), e);
        } finally {
            if (begins) {
                turn.end();
            }
        }
    }

    @Override
    public void outside(OutsideCode code) {
        turn.outside(code);
    }

    @Override
    public void atEnd(Runnable lettingGo) {
        onLane("atEnd");
        hold(lettingGo::run);
    }

    private void hold(Subscription subscription) {
        if (status == AgentPlatform.Status.RUNNING) {
            held.add(subscription);
        } else {
            letGo(subscription);
        }
    }

    /// Something the agent wants to be told: it is, on its lane, until it does not want to any more or ends.
    private class AgentListener<T> implements Consumer<T>, Subscription {
        private final Consumer<? super T> listener;
        private Subscription source = () -> {};
        private boolean open = true;

        AgentListener(Consumer<? super T> listener) {
            this.listener = listener;
        }

        Subscription listenTo(Function<Consumer<T>, Subscription> add) {
            source = add.apply(this);
            hold(this);
            return this;
        }

        @Override
        public void accept(T value) {
            hostLane.execute(() -> hear(value));
        }

        void hear(T value) {
            if (listens()) {
                actOn(value);
            }
        }

        void actOn(T value) {
            act(value, listener);
        }

        boolean listens() {
            return open && status == AgentPlatform.Status.RUNNING;
        }

        @Override
        public void cancel() {
            onLane("cancel");
            open = false;
            held.remove(this);
            source.cancel();
        }
    }

    /// Hears messages: those it wants, when they arrive.
    private final class MessageListener<M> extends AgentListener<MessageDispatch<M>>
            implements MessageDispatch.Hearer<M> {
        private final Interest<M> interest;
        private final Map<String, Instant> last = new HashMap<>(); // when it wanted one, by sender
        private final Consumer<MessageDispatch<M>> taking = this::take;

        MessageListener(Interest<M> interest, Consumer<? super Message<M>> listener) {
            super(reported -> listener.accept(reported.message()));
            this.interest = interest;
        }

        @Override
        public void accept(MessageDispatch<M> reported) {
            act(reported, taking); // what it wants is decided by its own code
        }

        private void take(MessageDispatch<M> reported) {
            Message<M> message = reported.message();
            boolean own = message.sender().equals(name());
            if ((own && message.isForAll()) || !wants(message)) {
                return;
            }
            if (own) { // it talks to itself, which nothing disturbs
                super.accept(reported);
                return;
            }
            draw(message);
            if (copies.size() == 1 && copies.getFirst().isZero()) {
                atOnce(reported); // nearly always, so it costs no object
            } else {
                takeCopies(reported);
            }
        }

        private void takeCopies(MessageDispatch<M> reported) {
            Arrival drawn = arrival == null ? new Arrival(reported.message()) : arrival;
            arrival = drawn;
            for (Duration late : copies) {
                if (late.isZero()) {
                    atOnceAs(reported, at -> hear(at, drawn));
                } else {
                    drawn.onTheirWay++;
                    hostLane.after(late, Phase.THINK, () -> hearLate(reported, drawn));
                }
            }
        }

        private void atOnce(MessageDispatch<M> reported) {
            if (isOnRunsLane) {
                reported.add(this);
            } else {
                hostLane.execute(() -> reach(reported));
            }
        }

        private void atOnceAs(MessageDispatch<M> reported, MessageDispatch.Hearer<M> hearer) {
            if (isOnRunsLane) {
                reported.addOnce(hearer);
            } else {
                hostLane.execute(() -> hearer.reach(reported));
            }
        }

        private boolean wants(Message<M> message) {
            if (!interest.wanted().test(message)) {
                return false;
            }
            if (interest.period().isZero()) {
                return true;
            }
            Instant before = last.get(message.sender());
            if (before != null && message.time().isBefore(before.plus(interest.period()))) {
                return false;
            }
            last.put(message.sender(), message.time());
            return true;
        }

        private void hearLate(MessageDispatch<M> reported, Arrival drawn) {
            drawn.onTheirWay--;
            if (platform.reaches(drawn.message, name())) {
                hear(reported, drawn);
            } else {
                drawn.noteInVain();
            }
        }

        private void hear(MessageDispatch<M> reported, Arrival drawn) {
            if (listens()) {
                drawn.note();
                actOn(reported);
            }
        }

        @Override
        public void reach(MessageDispatch<M> reported) {
            if (listens()) {
                note(reported.message());
                actOn(reported);
            }
        }
    }

    /// The host's lane, inside the fence.
    private final class AgentScheduler implements Scheduler {
        private void turn(Runnable task) {
            act(task, code -> {
                countWhatItSetsOff();
                code.run();
            });
        }

        @Override
        public Object run() {
            return hostLane.run();
        }

        @Override
        public Instant instant() {
            return hostLane.instant();
        }

        @Override
        public void execute(Runnable task) {
            hostLane.execute(() -> turn(task));
        }

        /// The calling thread is the agent's lane while it does the task.
        @Override
        public void exclusively(Runnable task) {
            hostLane.exclusively(() -> turn(task));
        }

        @Override
        public Task after(Duration delay, Phase phase, Runnable task) {
            onLane("after");
            return hostLane.after(delay, phase, () -> turn(task));
        }

        @Override
        public Task every(Duration period, Phase phase, Runnable task) {
            onLane("every");
            Task beats = hostLane.every(period, phase, () -> turn(task));
            Subscription untilEnd = beats::cancel;
            hold(untilEnd);
            return () -> {
                onLane("cancel");
                held.remove(untilEnd);
                beats.cancel();
            };
        }

        @Override
        public <T> CompletionStage<T> within(Duration limit, CompletionStage<T> stage) {
            onLane("within");
            return hostLane.within(limit, stage);
        }

        @Override
        public <T> CompletionStage<T> compute(Supplier<T> work) {
            onLane("compute");
            return hostLane.compute(work);
        }
    }

    /// The directory, telling of changes inside the fence.
    private final class Others implements Directory {
        @Override
        public List<Entry> agents() {
            onLane("agents");
            return platform.directory().agents();
        }

        @Override
        public List<ServiceDescription> capabilities(String agent) {
            onLane("capabilities");
            return platform.directory().capabilities(agent);
        }

        @Override
        public Subscription onChange(Consumer<? super Change> listener) {
            onLane("onChange");
            return new AgentListener<Change>(listener).listenTo(platform.directory()::onChange);
        }

        @Override
        public Subscription onDeparture(Consumer<? super Change.Went> listener) {
            onLane("onDeparture");
            return new AgentListener<Change.Went>(listener).listenTo(platform.directory()::onDeparture);
        }
    }
}
