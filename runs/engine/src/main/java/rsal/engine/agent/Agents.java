package rsal.engine.agent;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentSpec;
import rsal.agent.Directory;
import rsal.agent.Message;
import rsal.agent.MessageContent;
import rsal.agent.Topics;
import rsal.agent.bdi.Mind;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agent.platform.AgentPlatform;
import rsal.agent.platform.AgentTurns;
import rsal.agent.protocol.Act;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.SimulationControl;
import rsal.engine.communication.Faults;
import rsal.engine.communication.Links;
import rsal.engine.communication.Mailboxes;
import rsal.engine.communication.MessageRouter;
import rsal.engine.communication.Radio;
import rsal.engine.communication.Traffic;
import rsal.engine.event.ConversationLog;
import rsal.engine.event.Conversations;
import rsal.engine.event.EventLog;
import rsal.engine.event.RunClock;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.MindWords;
import rsal.engine.report.RunBroken;
import rsal.engine.report.Words;
import rsal.engine.robot.RobotPoses;
import rsal.engine.robot.RobotTeam;
import rsal.scenario.Communication;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.time.Scheduler;

/// The agents of a run: starts them, asks them for people, and journals what they say and what becomes of them. All
/// calls on the run's thread.
public final class Agents implements AutoCloseable {
    private static final String OPERATOR = "operator"; // who speaks for people
    public static final int MOST_BY_HAND = 500; // starts that people ask for, of a run

    private final RunPlan plan;
    private final Scheduler scheduler;
    private final RunClock clock;
    private final EventLog eventLog;
    private final MetricsObserver observer;
    private final Faults faults;
    private final RobotTeam team;
    private final RobotPoses where;
    private final Traffic traffic;
    private final AgentTurns turns;
    private final Map<String, PlannedAgent> started = new HashMap<>(); // by name
    private final NewestMessages newestMessages = new NewestMessages();
    private final Map<String, String> lastWords = new HashMap<>();
    private final UnhandledGoals unhandledGoals;
    private final SentRobots sent;
    private final Conversations conversations = new Conversations();
    private final ConversationLog talks;
    private final Mailboxes mailboxes;
    private final BeliefHistory beliefHistory;
    private final Links links;
    private Optional<Radio> radio = Optional.empty();
    private int byHand;
    private Optional<AgentPlatform> platform = Optional.empty();
    private boolean closed;

    public Agents(
            RunPlan plan,
            Scheduler scheduler,
            RunClock clock,
            EventLog eventLog,
            MetricsObserver observer,
            Faults faults,
            RobotTeam team,
            RobotPoses where,
            Traffic traffic,
            AgentTurns turns) {
        this.plan = plan;
        this.scheduler = scheduler;
        this.eventLog = eventLog;
        this.observer = observer;
        this.faults = faults;
        this.team = team;
        this.where = where;
        this.traffic = traffic;
        this.clock = clock;
        this.talks = new ConversationLog(clock);
        this.mailboxes = new Mailboxes(clock);
        this.beliefHistory = new BeliefHistory(clock);
        this.links = new Links(scheduler, this::robotOf);
        this.turns = turns;
        this.sent = new SentRobots(eventLog);
        this.unhandledGoals = new UnhandledGoals(eventLog);
    }

    /// Makes their society; from now on agents can be started.
    public void gather(Optional<SimulationControl> simulation) {
        AgentHostProvider provider = plan.mas().provider();
        AgentHost host = RunBroken.blaming(
                "Multi-agent system '%s'".formatted(provider.key()),
                () -> provider.create(plan.mas().settings(), scheduler));
        var agents = new AgentPlatform(scheduler, host, simulation, turns);
        platform = Optional.of(agents);
        agents.reserve(Topics.installed());
        agents.onMessage(this::heard);
        agents.onChange(this::changed);
        agents.onPrint(this::printed);
        agents.onMetric(this::measured);
        agents.onUnhandled(this::unhandled);
        radio = plan.communication().map(this::radio);
        agents.deliverBy(new MessageRouter(radio, faults, traffic, mailboxes, links));
    }

    private Radio radio(Communication limits) {
        return new Radio(limits, plan.map(), this::robotOf, this::place);
    }

    private Optional<Point2d> place(String robot) {
        return where.mapFromBase(robot).map(pose -> new Point2d(pose.x(), pose.y()));
    }

    private Optional<String> robot(String agent) {
        return Optional.ofNullable(started.get(agent)).flatMap(PlannedAgent::robot);
    }

    /// Empty when it has none.
    private String robotOf(String agent) {
        return robot(agent).orElse("");
    }

    public boolean isGathered() {
        return platform.isPresent();
    }

    public void start(PlannedAgent agent) {
        started.put(agent.name(), agent);
        agent.robot().ifPresent(robot -> faults.mans(robot, agent.name()));
        platform.orElseThrow()
                .start(new AgentSpec(
                        agent.name(),
                        agent.role(),
                        agent.type(),
                        agent.arguments(),
                        agent.robot().flatMap(team::robot),
                        agent.seed()));
    }

    /// How one was started; empty when there never was one of that name.
    public Optional<PlannedAgent> planned(String name) {
        return Optional.ofNullable(started.get(name));
    }

    /// Starts one because a person wants it.
    ///
    /// @param how in words, for the event
    /// @param done the answer when it is there
    public Answer start(PlannedAgent agent, String how, Answer done) {
        if (isRunning(agent.name())) {
            return new Answer.Refused("Agent '%s' runs already.".formatted(agent.name()));
        }
        if (byHand == MOST_BY_HAND) {
            return new Answer.Refused(
                    "People have started agents %d times in this run, which is the maximum. Maybe let the scenario start them."
                            .formatted(MOST_BY_HAND));
        }
        Optional<String> missing = agent.robot().filter(robot -> !team.has(robot) || faults.isGone(robot));
        if (missing.isPresent()) {
            return new Answer.Refused("Its robot '%s' is not in this run.".formatted(missing.get()));
        }
        Optional<PlannedAgent> before = planned(agent.name());
        byHand++;
        try {
            start(agent);
        } catch (RuntimeException e) { // of a host that can't, as its system is another's code
            before.ifPresentOrElse(known -> started.put(known.name(), known), () -> started.remove(agent.name()));
            return new Answer.Refused("Agent '%s' can't be started: %s".formatted(agent.name(), e.getMessage()));
        }
        eventLog.event(OPERATOR, agent.name(), how);
        return done;
    }

    /// Ends one because a person wants it.
    public Answer stop(String name) {
        if (!isRunning(name)) {
            return notRunning(name);
        }
        eventLog.event(OPERATOR, name, "stopped");
        platform.orElseThrow().stop(name);
        return new Answer.Done();
    }

    /// Says something in the operator's name.
    ///
    /// @param to name of an agent; empty for all
    /// @throws IllegalArgumentException with a sentence when that is no message
    public Answer say(String to, String topic, Map<String, String> typed) {
        return to.isEmpty() || isRunning(to) ? say(to, OperatorMessages.read(topic, typed)) : notRunning(to);
    }

    private <M> Answer say(String to, OperatorMessages.Phrase<M> phrase) {
        String words =
                Words.clipped(new Message<>(phrase.topic(), OPERATOR, to, scheduler.instant(), phrase.message()));
        String said = to.isEmpty() ? "all are told on %s: %s" : "is told on %s: %s";
        eventLog.event(OPERATOR, to, said.formatted(phrase.topic().name(), words));
        if (to.isEmpty()) {
            platform.orElseThrow().publish(OPERATOR, phrase.topic(), phrase.message());
        } else {
            platform.orElseThrow().send(OPERATOR, to, phrase.topic(), phrase.message());
        }
        return new Answer.Done();
    }

    private boolean isRunning(String name) {
        return platform.flatMap(agents -> agents.view(name))
                .filter(view -> view.status() == AgentPlatform.Status.RUNNING)
                .isPresent();
    }

    /// The answer to those that want something of an agent that does not run, or never was there.
    public Answer notRunning(String name) {
        return planned(name).isPresent()
                ? new Answer.Refused("Agent '%s' does not run. Maybe start it again.".formatted(name))
                : Answer.Refused.noAgent(name, started.keySet());
    }

    /// A robot has left: its agents end as they would at the end of the run.
    public void leave(String robot) {
        sent.forget(robot);
        platform.ifPresent(agents -> agents.directory().agents().stream()
                .filter(agent -> agent.robot().equals(robot))
                .forEach(agent -> agents.stop(agent.name())));
    }

    /// Whether somebody hears where a robot is to drive: an agent of it, or one without a robot, as those who send
    /// teams.
    public boolean takeOrdersFor(String robot) {
        AgentPlatform all = platform.orElseThrow();
        return all.directory().agents().stream()
                .filter(agent -> agent.robot().equals(robot) || agent.robot().isEmpty())
                .anyMatch(agent -> all.listens(agent.name(), NewGoal.TOPIC));
    }

    /// Asks those who take such orders to have a robot drive somewhere.
    ///
    /// @param onEnd told how that ended, unless it is sent elsewhere before
    public void ask(String robot, Pose2d mapFromGoal, Consumer<GoalReached> onEnd) {
        eventLog.event(OPERATOR, robot, "sent to " + mapFromGoal.rounded());
        sent.send(robot, mapFromGoal, onEnd);
        platform.orElseThrow().publish(OPERATOR, NewGoal.TOPIC, new NewGoal(robot, mapFromGoal));
    }

    private void heard(Message<?> message) {
        if (closed || faults.isSilent(message.sender())) {
            return;
        }
        String words = Words.of(message); // if it can't be made, the one who says it is told, and nothing was said
        traffic.said(message);
        eventLog.said(message, words);
        newestMessages.sent(message.sender(), message.topic().name() + ": " + words, clock.elapsed());
        switch (message.content()) {
            case Act act
            when !isNew(message, act) ->
                eventLog.hash(message.sender(), message.topic().name(), words);
            case Act act -> {
                String kind = MessageContent.eventKindOf(act.content()).orElse(MessageContent.MESSAGE);
                eventLog.event(kind, message, words);
                observer.heard(message.sender(), act.content());
            }
            case Object content -> {
                MessageContent.eventKindOf(content)
                        .ifPresentOrElse(
                                kind -> eventLog.event(kind, message, words), () -> eventLog.routine(message, words));
                observer.heard(message.sender(), content);
                if (content instanceof GoalReached end) {
                    sent.ended(end);
                }
            }
        }
    }

    private boolean isNew(Message<?> message, Act act) {
        boolean isNew = conversations.isNew(message.sender(), message.to(), act);
        if (isNew) {
            talks.said(message, act);
        } else {
            talks.repeated(message, act);
        }
        return isNew;
    }

    /// How an agent was started, and what it believes, wants and says now; empty when there never was one of that name.
    ///
    /// @param now in real time [ns]
    /// @throws IllegalArgumentException when it can't tell
    public Optional<AgentInspection> inside(String name, long now) {
        PlannedAgent agent = started.get(name);
        if (agent == null) {
            return Optional.empty();
        }
        Optional<AgentPlatform.View> shown = platform.orElseThrow().view(name);
        Optional<Mind.View> mind = platform.orElseThrow().look(name, Mind.View.class);
        beliefHistory.look(name, held(shown, mind), now);
        return Optional.of(new AgentInspection(
                name,
                Optional.of(agent),
                shown,
                mind,
                platform.orElseThrow().look(name, Mind.Program.class),
                beliefHistory.of(name),
                Optional.of(mailboxes.of(name)),
                talks.of(name),
                traffic.hearings(name)));
    }

    /// Of all that ever were.
    public List<String> names() {
        return List.copyOf(started.keySet());
    }

    private static MindWords held(Optional<AgentPlatform.View> shown, Optional<Mind.View> mind) {
        return MindWords.of(
                mind.map(Mind.View::beliefs)
                        .or(() -> shown.map(AgentPlatform.View::beliefs))
                        .orElse(Map.of()),
                mind.map(Mind.View::goals).orElse(List.of()));
    }

    /// After each step: notes what changed in those that people look into.
    public void observe() {
        platform.ifPresent(agents -> beliefHistory.step(name -> {
            try {
                return Optional.of(held(agents.view(name), agents.look(name, Mind.View.class)));
            } catch (IllegalArgumentException _) { // the one that asks is told
                return Optional.empty();
            }
        }));
    }

    /// Which robots' agents hear each other. Where nothing is limited, and all hear all, only what is used is told.
    ///
    /// @param chosen id of the robot whose links are told when there are many robots; maybe of none
    /// @param now in real time [ns]
    public Answer.Linked links(String chosen, long now) {
        if (platform.isEmpty()) {
            return Answer.Linked.NONE;
        }
        var speakers = new LinkedHashMap<String, List<String>>(); // names of those who run, by robot
        for (Directory.Entry agent : platform.get().directory().agents()) {
            if (!agent.robot().isEmpty()) {
                speakers.computeIfAbsent(agent.robot(), _ -> new ArrayList<>()).add(agent.name());
            }
        }
        var places = new HashMap<String, Optional<Point2d>>();
        var air = new Links.Air(
                (from, to) -> radio.filter(channel -> hears(
                                channel, speakers.getOrDefault(from, List.of()), speakers.getOrDefault(to, List.of())))
                        .isPresent(),
                (one, other) -> radio.orElseThrow()
                        .reaches(places.computeIfAbsent(one, this::place), places.computeIfAbsent(other, this::place)));
        return links.look(speakers.keySet(), chosen, air, now);
    }

    /// From now on it is noted who hears whom, as somebody will look.
    ///
    /// @param now in real time [ns]
    public void noteLinks(long now) {
        links.note(now);
    }

    /// Whether anybody of those in range would be heard by one of the others.
    private boolean hears(Radio channel, List<String> senders, List<String> listeners) {
        return senders.stream()
                .filter(sender -> channel.sends(sender, scheduler.instant()))
                .anyMatch(sender -> listeners.stream().anyMatch(listener -> !faults.blocks(sender, listener)));
    }

    /// @param now in real time [ns]
    public void beat(long now) {
        beliefHistory.beat(now);
        links.beat(now);
    }

    /// What those believe and want that show it, by name.
    public Map<String, Mind.View> minds() {
        return platform.map(agents -> lookInto(agents.views())).orElse(Map.of());
    }

    /// The same of some of them.
    public Map<String, Mind.View> minds(List<String> some) {
        return platform.map(agents -> lookInto(some.stream()
                        .flatMap(name -> agents.view(name).stream())
                        .toList()))
                .orElse(Map.of());
    }

    private Map<String, Mind.View> lookInto(List<AgentPlatform.View> views) {
        var minds = new TreeMap<String, Mind.View>();
        views.stream()
                .filter(view -> view.status() == AgentPlatform.Status.RUNNING)
                .map(view -> view.agent().name())
                .forEach(name ->
                        platform.orElseThrow().look(name, Mind.View.class).ifPresent(mind -> minds.put(name, mind)));
        return minds;
    }

    private void changed(AgentPlatform.View view) {
        String words = switch (view.status()) {
            case RUNNING -> view.state().isEmpty() ? "has started" : view.state();
            case ENDED -> "has ended";
            case FAILED -> "has failed: " + view.state();
        };
        String name = view.agent().name();
        if (!closed && !words.equals(lastWords.put(name, words))) {
            eventLog.event(view.status() == AgentPlatform.Status.FAILED ? "fault" : "agent", name, words);
            beliefHistory.does(name, words);
        }
    }

    /// Each line counts, also one that is equal to the last.
    private void printed(AgentPlatform.Print print) {
        if (!closed) {
            lastWords.put(print.agent(), print.line());
            eventLog.event("print", print.agent(), print.line());
            beliefHistory.does(print.agent(), print.line());
        }
    }

    private void measured(AgentPlatform.Metric metric) {
        if (!closed) {
            eventLog.hash("metric", metric.agent(), metric.name(), Double.toString(metric.value()));
            observer.published(metric.agent(), robot(metric.agent()), metric.name(), metric.value());
        }
    }

    private void unhandled(AgentPlatform.Unhandled goal) {
        if (!closed) {
            unhandledGoals.note(goal);
        }
    }

    /// Goals for which agents had no plan at all, by their names; the first ten of each.
    public Map<String, List<String>> unhandledGoals() {
        return unhandledGoals.byAgent();
    }

    /// What went wrong with those that have failed, by name.
    public Map<String, String> failed() {
        return platform.stream()
                .flatMap(agents -> agents.views().stream())
                .filter(view -> view.status() == AgentPlatform.Status.FAILED)
                .collect(Collectors.toMap(view -> view.agent().name(), AgentPlatform.View::state));
    }

    public List<AgentView> views() {
        return platform.stream()
                .flatMap(agents -> agents.views().stream())
                .map(this::view)
                .toList();
    }

    private AgentView view(AgentPlatform.View view) {
        String name = view.agent().name();
        return new AgentView(view, newestMessages.of(name), newestMessages.newest(name));
    }

    /// Stops them all; what they still say is not journaled.
    @Override
    public void close() {
        closed = true;
        platform.ifPresent(AgentPlatform::close);
    }
}
