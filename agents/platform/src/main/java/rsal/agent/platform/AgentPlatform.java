package rsal.agent.platform;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import rsal.agent.AgentHost;
import rsal.agent.AgentSpec;
import rsal.agent.ChannelModel;
import rsal.agent.Directory;
import rsal.agent.Message;
import rsal.agent.MessageTransport;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.device.Listeners;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.time.Scheduler;

/// The agents of one run: starts and stops them, carries what they say, knows who is there. The same on all
/// hosts.
///
/// What is said is heard at the same instant, after what is running now, by all who listen by then but the one
/// who said it, in the order in which they subscribed, or by the one it is said to, unless [#deliverBy] says
/// otherwise; where the host carries it ([AgentHost#carrier]), by each as soon as it has reached that one. An agent
/// that throws ends alone: its robot is told to stop, and the others learn why it went.
///
/// All calls on the run's thread.
public final class AgentPlatform implements AutoCloseable {
    private static final Logger LOG = System.getLogger(AgentPlatform.class.getName());
    private static final int LAST_WORDS = 500; // ms

    private final Scheduler scheduler;
    private final AgentHost host;
    private final Optional<MessageTransport> carrier;
    private final Optional<SimulationControl> simulation;
    private final Map<String, AgentRuntime> members = new LinkedHashMap<>();
    private final Map<String, TopicBus<?>> channels = new HashMap<>();
    private final List<Consumer<? super Message<?>>> traffic = new CopyOnWriteArrayList<>(); // may change while told
    private final Listeners<View> changes = listeners();
    private final Listeners<Print> prints = listeners();
    private final Listeners<Metric> metrics = listeners();
    private final Listeners<Unhandled> unhandled = listeners();
    private final Roster roster = new Roster();
    private final AgentTurns turns;
    private ChannelModel delivery = ChannelModel.PERFECT;

    public AgentPlatform(Scheduler scheduler, AgentHost host, Optional<SimulationControl> simulation) {
        this(scheduler, host, simulation, new AgentTurns());
    }

    /// @param turns where is counted who is at work
    public AgentPlatform(
            Scheduler scheduler, AgentHost host, Optional<SimulationControl> simulation, AgentTurns turns) {
        this.scheduler = scheduler;
        this.host = host;
        this.carrier = host.carrier();
        this.simulation = simulation;
        this.turns = turns;
        host.onKilled(this::stop);
    }

    /// Starts an agent. It is in the directory at once and begins after what is running now.
    ///
    /// @throws IllegalArgumentException when one of that name runs already
    public void start(AgentSpec spec) {
        AgentRuntime before = members.get(spec.name());
        if (before != null && before.status() == Status.RUNNING) {
            throw new IllegalArgumentException("An agent '%s' runs already; names are unique.".formatted(spec.name()));
        }
        var member = new AgentRuntime(this, spec, host.lane(spec.name()));
        members.remove(spec.name()); // one that starts again comes last
        members.put(spec.name(), member);
        roster.came(member.entry());
        changed(member);
        member.start();
    }

    /// Stops an agent. One that does not run is left as it is.
    ///
    /// @throws IllegalArgumentException when there never was one of that name
    public void stop(String name) {
        AgentRuntime member = members.get(name);
        if (member == null) {
            throw new IllegalArgumentException(
                    "There is no agent '%s'; there are %s.".formatted(name, members.keySet()));
        }
        member.stop();
    }

    public Directory directory() {
        return roster;
    }

    /// From now on this decides what becomes of what is said.
    public void deliverBy(ChannelModel way) {
        delivery = way;
    }

    List<Duration> copies(Message<?> message, String listener) {
        return delivery.copies(message, listener);
    }

    /// Whether what comes late still arrives.
    boolean reaches(Message<?> message, String listener) {
        return delivery.reaches(message, listener);
    }

    void heard(Message<?> message, String listener) {
        delivery.heard(message, listener);
    }

    void unheard(Message<?> message, String listener) {
        delivery.unheard(message, listener);
    }

    /// From now on the names of these topics are theirs alone, also when somebody else uses one of them first.
    ///
    /// @throws IllegalArgumentException when somebody has already, for another type
    public void reserve(Collection<Topic<?>> topics) {
        topics.forEach(topic -> channel(topic, "platform"));
    }

    /// Says something in a person's name.
    ///
    /// @throws IllegalArgumentException when the message is not of the topic's type, or the topic's name is taken
    /// by messages of another type
    public <M> void publish(String sender, Topic<M> topic, M message) {
        say(sender, "", topic, message);
    }

    /// Says something to one agent in a person's name. When none of that name listens, nobody hears it.
    ///
    /// @throws IllegalArgumentException as [#publish] does, and when the name is empty
    public <M> void send(String sender, String to, Topic<M> topic, M message) {
        if (to.isEmpty()) {
            throw new IllegalArgumentException("'%s' was sent to nobody. Maybe publish it.".formatted(message));
        }
        say(sender, to, topic, message);
    }

    private <M> void say(String sender, String to, Topic<M> topic, M message) {
        if (!topic.type().isInstance(message)) {
            throw new IllegalArgumentException("Topic '%s' carries %s, not '%s'."
                    .formatted(topic.name(), topic.type().getSimpleName(), message));
        }
        TopicBus<M> channel = channel(topic, sender);
        var said = new Message<>(topic, sender, to, scheduler.instant(), message);
        traffic.forEach(listener -> listener.accept(said));
        carrier.ifPresentOrElse(
                way -> way.carry(said, agent -> deliver(said, publishing -> channel.deliver(publishing, agent))),
                () -> scheduler.execute(() -> deliver(said, channel::deliver)));
    }

    private <M> void deliver(Message<M> said, Consumer<MessageDispatch<M>> listeners) {
        var publishing = new MessageDispatch<>(said);
        listeners.accept(publishing);
        if (publishing.isHeard()) {
            scheduler.execute(publishing);
        }
    }

    /// Whether an agent's lane is the run's own.
    boolean runs(Scheduler lane) {
        return lane.equals(scheduler);
    }

    /// Whether an agent hears what is said about a topic.
    public boolean listens(String agent, Topic<?> topic) {
        TopicBus<?> channel = channels.get(topic.name());
        return channel != null && channel.topic().equals(topic) && channel.isHeardBy(agent);
    }

    /// Hears everything that is said, before those it is said to. What it throws, the one who speaks gets, as when the
    /// text of a message can't be made; then nobody hears that message.
    public Subscription onMessage(Consumer<? super Message<?>> listener) {
        traffic.add(listener);
        return () -> traffic.remove(listener);
    }

    /// Hears how an agent is now whenever its status or state has changed, its start included.
    public Subscription onChange(Consumer<? super View> listener) {
        return changes.add(listener);
    }

    /// Hears each line that agents print.
    public Subscription onPrint(Consumer<? super Print> listener) {
        return prints.add(listener);
    }

    /// Hears each value that agents publish for the results.
    public Subscription onMetric(Consumer<? super Metric> listener) {
        return metrics.add(listener);
    }

    /// Hears of each goal for which an agent has no plan.
    public Subscription onUnhandled(Consumer<? super Unhandled> listener) {
        return unhandled.add(listener);
    }

    /// All agents ever started, in the order in which they started, with what they show of themselves.
    public List<View> views() {
        return members.values().stream().map(AgentRuntime::view).toList();
    }

    /// How one agent is now, as in [#views]; empty when there never was one of that name.
    public Optional<View> view(String agent) {
        return member(agent).map(AgentRuntime::view);
    }

    /// What an agent reveals of itself now, by the type of it ([rsal.agent.AgentContext#reveal]).
    ///
    /// @return empty when it reveals nothing of that type, does not run, or never was there
    /// @throws IllegalArgumentException when it can't tell
    public <T> Optional<T> look(String agent, Class<T> type) {
        return member(agent).flatMap(member -> member.look(type));
    }

    /// Stops all agents, the newest first, then the host. Waits up to half a second for the last words of agents whose
    /// code runs elsewhere.
    @Override
    public void close() {
        List<AgentRuntime> all = List.copyOf(members.values()).reversed();
        all.forEach(AgentRuntime::stop);
        awaitLastWords(
                all.stream().flatMap(member -> member.lastWords().stream()).toArray(CompletableFuture<?>[]::new));
        all.forEach(AgentRuntime::leave);
        host.close();
    }

    private static void awaitLastWords(CompletableFuture<?>... lastWords) {
        try {
            CompletableFuture.allOf(lastWords).get(LAST_WORDS, TimeUnit.MILLISECONDS);
        } catch (TimeoutException | ExecutionException _) {
            // the run does not wait for those that have more to say
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }

    /// Also one that has ended.
    Optional<AgentRuntime> member(String name) {
        return Optional.ofNullable(members.get(name));
    }

    /// Tells an agent what is said there, until it does not want that any more.
    <M> Subscription listen(Topic<M> topic, String agent, Consumer<? super MessageDispatch<M>> listener) {
        TopicBus<M> channel = channel(topic, agent);
        if (!channel.isHeardBy(agent)) {
            carrier.ifPresent(way -> way.listens(agent, topic));
        }
        Subscription heard = channel.add(agent, listener);
        return () -> {
            boolean listened = channel.isHeardBy(agent);
            heard.cancel();
            if (listened && !channel.isHeardBy(agent)) {
                carrier.ifPresent(way -> way.ignores(agent, topic));
            }
        };
    }

    void offer(Directory.Entry agent, ServiceDescription capability) {
        roster.offer(agent, capability);
        carrier.ifPresent(way -> way.offers(agent.name(), capability));
    }

    void withdraw(Directory.Entry agent, ServiceDescription capability) {
        if (roster.withdraw(agent, capability)) {
            carrier.ifPresent(way -> way.withdraws(agent.name(), capability));
        }
    }

    AgentTurns turns() {
        return turns;
    }

    Optional<SimulationControl> simulation() {
        return simulation;
    }

    /// @param user who wants it, to name when somebody else wants it for another type
    private <M> TopicBus<M> channel(Topic<M> topic, String user) {
        TopicBus<?> channel =
                channels.computeIfAbsent(topic.name(), _ -> new TopicBus<>(topic, user, AgentPlatform::listeners));
        if (!channel.topic().equals(topic)) {
            throw new IllegalArgumentException(
                    "Topic '%s' carries %s since '%s' used it first, not %s. Maybe give yours another name."
                            .formatted(
                                    topic.name(),
                                    channel.topic().type().getName(),
                                    channel.firstUser(),
                                    topic.type().getName()));
        }
        @SuppressWarnings("unchecked") // made for an equal topic
        var same = (TopicBus<M>) channel;
        return same;
    }

    void changed(AgentRuntime member) {
        if (!changes.isEmpty()) {
            changes.publish(member.view());
        }
    }

    void printed(Print print) {
        prints.publish(print);
    }

    void measured(Metric metric) {
        metrics.publish(metric);
    }

    void unhandled(Unhandled goal) {
        unhandled.publish(goal);
    }

    /// @param reason empty when it ended as it should
    void went(AgentRuntime member, String reason) {
        host.end(member.name());
        roster.remove(member.entry());
        scheduler.execute(() -> roster.went(member.entry(), reason)); // after its last words
        changed(member);
    }

    private static <T> Listeners<T> listeners() {
        return new Listeners<>(e -> LOG.log(Level.ERROR, "A listener failed and is not notified any more.", e));
    }

    /// A goal for which an agent has no plan.
    ///
    /// @param where in the agent's file; empty when nobody knows
    public record Unhandled(String agent, String goal, String where) {}

    /// What an agent printed.
    public record Print(String agent, String line) {}

    /// A value that an agent published for the results.
    public record Metric(String agent, String name, double value) {}

    /// An agent as people see it.
    ///
    /// @param state what it says it is doing; the failure's message when it failed
    /// @param beliefs what it shows, by name, in the order in which it first showed them
    /// @param sent how many messages it has published
    public record View(Directory.Entry agent, Status status, String state, Map<String, String> beliefs, long sent) {
        public View {
            beliefs = Collections.unmodifiableMap(new LinkedHashMap<>(beliefs));
        }
    }

    public enum Status {
        RUNNING,
        ENDED,
        FAILED
    }

    private static final class Roster implements Directory {
        private final Listeners<Change> listeners = listeners();
        private final Listeners<Change.Went> departures = listeners();
        private final Map<String, SortedMap<String, ServiceDescription>> offers = new HashMap<>(); // by agent and name
        private List<Entry> agents = List.of();

        @Override
        public List<Entry> agents() {
            return agents;
        }

        @Override
        public List<ServiceDescription> capabilities(String agent) {
            return List.copyOf(
                    offers.getOrDefault(agent, Collections.emptySortedMap()).values());
        }

        @Override
        public Subscription onChange(Consumer<? super Change> listener) {
            return listeners.add(listener);
        }

        @Override
        public Subscription onDeparture(Consumer<? super Change.Went> listener) {
            return departures.add(listener);
        }

        void offer(Entry agent, ServiceDescription capability) {
            offers.computeIfAbsent(agent.name(), _ -> new TreeMap<>()).put(capability.name(), capability);
            listeners.publish(new Change.Offered(agent, capability));
        }

        /// @return whether it was offered
        boolean withdraw(Entry agent, ServiceDescription capability) {
            SortedMap<String, ServiceDescription> own = offers.get(agent.name());
            if (own == null || !own.remove(capability.name(), capability)) {
                return false;
            }
            listeners.publish(new Change.Withdrew(agent, capability));
            return true;
        }

        void came(Entry agent) {
            var more = new ArrayList<>(agents);
            more.add(agent);
            agents = Collections.unmodifiableList(more);
            listeners.publish(new Change.Came(agent));
        }

        void remove(Entry agent) {
            agents = agents.stream().filter(other -> !other.equals(agent)).toList();
            offers.remove(agent.name());
        }

        void went(Entry agent, String reason) {
            var went = new Change.Went(agent, reason);
            listeners.publish(went);
            departures.publish(went);
        }
    }
}
