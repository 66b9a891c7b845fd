package rsal.engine;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import rsal.agent.bdi.Mind;
import rsal.agent.platform.AgentTurns;
import rsal.data.Pose2d;
import rsal.device.SimulationControl;
import rsal.engine.agent.Agents;
import rsal.engine.agent.TypedAgent;
import rsal.engine.communication.Faults;
import rsal.engine.communication.RobotBreaker;
import rsal.engine.communication.RobotRadio;
import rsal.engine.communication.Traffic;
import rsal.engine.event.ChattyTopics;
import rsal.engine.event.EventLog;
import rsal.engine.event.RunClock;
import rsal.engine.metric.MetricsObserver;
import rsal.engine.operator.RobotCommands;
import rsal.engine.operator.SentGoals;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.Reception;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunBroken;
import rsal.engine.report.Teammate;
import rsal.engine.report.TopicTraffic;
import rsal.engine.robot.RobotPoses;
import rsal.engine.robot.RobotSystems;
import rsal.engine.robot.RobotTeam;
import rsal.engine.world.DeviceFactory;
import rsal.engine.world.DynamicRobots;
import rsal.engine.world.Overlay;
import rsal.engine.world.Proxies;
import rsal.engine.world.RobotViews;
import rsal.engine.world.SimulatedWorld;
import rsal.engine.world.ThingArrivals;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.text.Counted;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.system.CommandTimeout;
import rsal.system.RobotRecorder;
import rsal.system.RobotSystem;
import rsal.system.RunControl;
import rsal.time.Scheduler;

/// Everything that takes part in a run, put together after the plan: the robots of the robot systems, their
/// software devices, the agents. All calls on the run's thread.
final class RunAssembly implements AutoCloseable {
    private final RunPlan plan;
    private final Scheduler scheduler;
    private final RunClock clock;
    private final EventLog eventLog;
    private final MetricsObserver observer;
    private final RobotSystems systems;
    private final DynamicRobots dynamicRobots;
    private final RobotBreaker breaker;
    private final Traffic traffic;
    private final Faults faults;
    private final SimulatedWorld world;
    private final DeviceFactory deviceFactory;
    private final Proxies proxies;
    private final DrawnPlans drawnPlans;
    private final Agents agents;
    private final RobotCommands robotCommands;
    private final RobotViews robotViews;
    private final RobotTeam team = new RobotTeam();
    private final RobotPoses where;
    private final RunBridges bridges;
    private final List<RobotSystem.Change> early = new ArrayList<>(); // before all was put together
    private Optional<RobotRecorder> recorder = Optional.empty();
    private boolean assembled;
    private boolean closed;

    /// Makes the robot systems; nothing moves yet.
    ///
    /// @param traffic where is counted what agents say
    /// @param turns where is counted which agents are at work
    /// @param goals to which people send robots
    RunAssembly(
            RunPlan plan,
            Scheduler scheduler,
            RunClock clock,
            EventLog eventLog,
            MetricsObserver observer,
            Traffic traffic,
            AgentTurns turns,
            SentGoals goals) {
        this.plan = plan;
        this.scheduler = scheduler;
        this.clock = clock;
        this.eventLog = eventLog;
        this.bridges = new RunBridges(eventLog);
        this.observer = observer;
        this.dynamicRobots = new DynamicRobots(plan);
        this.systems = new RobotSystems(plan, scheduler);
        this.where = new RobotPoses(systems, team);
        observer.attach(where, systems::simulation);
        this.breaker = new RobotBreaker(systems, plan.faults());
        this.traffic = traffic;
        this.faults = new Faults(plan, scheduler, eventLog, observer, traffic, breaker);
        this.world = new SimulatedWorld(plan, systems, scheduler, eventLog, observer, dynamicRobots, team, faults);
        this.proxies = new Proxies(systems, team, where, scheduler, eventLog);
        var radio = new RobotRadio(
                plan.communication(),
                plan.map(),
                scheduler,
                robot -> where.mapFromBase(robot).map(Pose2d::position),
                faults::isGone);
        this.deviceFactory = new DeviceFactory(plan, scheduler, eventLog, breaker, world, team, radio, this::overlay);
        this.agents = new Agents(plan, scheduler, clock, eventLog, observer, faults, team, where, traffic, turns);
        this.drawnPlans = new DrawnPlans(team, scheduler);
        this.robotCommands = new RobotCommands(plan.map(), eventLog, faults, world, team, agents, goals);
        this.robotViews = new RobotViews(team, world, faults, proxies, scheduler);
    }

    /// Has the robots recorded once they are there. To be called before it begins.
    void recordBy(RobotRecorder who) {
        recorder = Optional.of(who);
    }

    /// Has the time of the robots' own simulator said, if they have one. To be called before it begins.
    void onTime(Consumer<Instant> listener) {
        systems.onTime(listener);
    }

    /// All is done that was due by a time of that simulator.
    void reached(Instant time) {
        systems.reached(time);
    }

    /// Finds the robots and, once they are there, begins.
    void begin() {
        systems.onChange(this::changed);
        systems.discover()
                .whenComplete((found, error) -> scheduler.execute(() -> {
                    if (error instanceof RunBroken broken) {
                        throw broken;
                    }
                    assemble(found);
                }));
    }

    private void assemble(List<Robot> found) {
        clock.start();
        Map<String, Robot> byId = // the first of each id
                found.stream().collect(Collectors.toMap(Robot::id, Function.identity(), (first, _) -> first));
        for (PlannedRobot planned : plan.robots()) {
            String id = planned.spec().id();
            Robot robot = byId.get(id);
            if (robot != null) {
                equip(robot, planned);
            } else {
                faults.await(id);
                eventLog.event("run", id, "is not there yet; it joins when it is found");
            }
        }
        world.begin();
        recorder.ifPresent(
                who -> bridges.add(who.open(bridgeContext(CommandTimeout.none(), Optional.empty(), false), scheduler)));
        robotCommands.begin();
        agents.gather(systems.simulation());
        systems.simulation().ifPresent(new ThingArrivals(plan, scheduler, eventLog)::begin);
        faults.begin();
        List<PlannedAgent> first = plan.agents().stream()
                .filter(agent -> agent.robot().map(team::has).orElse(true)) // others start with their robots
                .toList();
        first.forEach(agents::start);
        eventLog.event(
                "run",
                "",
                "%s, %s".formatted(Counted.of(team.robots().size(), "robot"), Counted.of(first.size(), "agent")));
        assembled = true;
        early.forEach(this::changed);
        early.clear();
    }

    private void equip(Robot robot, PlannedRobot planned) {
        deviceFactory.equip(robot, planned);
        proxies.join(planned);
        drawnPlans.join(planned.spec());
    }

    private Overlay overlay(RobotSpec spec) {
        return new Overlay(spec, () -> where.known(spec), systems::simulation, proxies::names, eventLog);
    }

    private void changed(RobotSystem.Change change) {
        if (closed) {
            return;
        }
        if (!assembled) {
            early.add(change);
            return;
        }
        switch (change) {
            case RobotSystem.Change.Appeared(Robot robot) -> {
                if (!dynamicRobots.isExpected(robot.id())) { // else that it was added is told
                    eventLog.event("run", robot.id(), "is there");
                }
                faults.appeared(robot.id());
                if (!team.has(robot.id())) {
                    join(robot);
                }
            }
            case RobotSystem.Change.Gone(String robot, String reason) -> {
                if (!faults.isGone(robot)) { // else that was told
                    eventLog.event("fault", robot, "is gone: " + reason);
                }
            }
            case RobotSystem.Change.Removed(String robot) -> {
                if (!world.isTakenOut(robot)) { // else that is told
                    eventLog.event("run", robot, "was removed");
                }
                leave(robot);
            }
        }
    }

    /// Gives a robot that joins what was planned for it, or else what those like it have.
    private void join(Robot robot) {
        String id = robot.id();
        PlannedRobot planned = dynamicRobots.planned(id).orElseGet(() -> dynamicRobots.plan(robot, world.truth(id)));
        observer.joined(id, robot.role());
        equip(robot, planned);
        faults.joined(id);
        bridges.join(team.robot(id).orElseThrow());
        robotCommands.joined(id);
        dynamicRobots.agents(id).forEach(agents::start);
    }

    RunBridges bridges() {
        return bridges;
    }

    /// Lets go of all that a robot had.
    private void leave(String id) {
        bridges.leave(id);
        team.leave(id);
        robotCommands.left(id);
        proxies.leave(id);
        drawnPlans.leave(id);
        where.leave(id);
        agents.leave(id);
        deviceFactory.leave(id);
        breaker.leave(id);
        faults.left(id);
    }

    /// Looks at everything after a step.
    ///
    /// @return how the run ends, if it is over
    Optional<String> observe() {
        agents.observe();
        return observer.look(team.robots());
    }

    /// Whether robots and agents are there.
    boolean isReady() {
        return agents.isGathered();
    }

    /// The world, for people to see and change it.
    SimulatedWorld world() {
        return world;
    }

    /// By what people tell robots what to do.
    RobotCommands robotCommands() {
        return robotCommands;
    }

    List<RobotView> robotViews() {
        return robotViews.all();
    }

    /// @param time since the run's start
    Answer readings(String robot, Duration time) {
        return team.robot(robot)
                .<Answer>map(known -> new Answer.Read(time, robotViews.readings(known)))
                .orElseGet(() -> world.unknown(robot));
    }

    Answer costs(String robot) {
        return team.robot(robot)
                .<Answer>map(known -> new Answer.Costed(robotViews.costs(known)))
                .orElseGet(() -> world.unknown(robot));
    }

    Answer bridge(
            BridgeProvider provider,
            InetSocketAddress at,
            CommandTimeout timeout,
            RunControl control,
            boolean isPaced) {
        try {
            Bridge bridge = provider.open(at, bridgeContext(timeout, Optional.of(control), isPaced), scheduler);
            bridges.add(bridge);
            return new Answer.Bridged(bridge.offers());
        } catch (IOException e) {
            return new Answer.Refused(String.valueOf(e.getMessage()));
        }
    }

    private BridgeContext bridgeContext(CommandTimeout timeout, Optional<RunControl> control, boolean isPaced) {
        return new BridgeContext(
                List.copyOf(team.robots().values()),
                plan.map(),
                systems.simulation(),
                plan.scene().services(),
                timeout,
                control,
                isPaced);
    }

    List<AgentView> agentViews() {
        return agents.views();
    }

    Map<String, Mind.View> minds() {
        return agents.minds();
    }

    /// What some agents believe and want.
    Map<String, Mind.View> minds(List<String> some) {
        return agents.minds(some);
    }

    /// @param now in real time [ns]
    Answer inside(String agent, long now) {
        return agents.inside(agent, now).<Answer>map(Answer.Seen::new).orElseGet(() -> agents.notRunning(agent));
    }

    /// @param now in real time [ns]
    Answer.Linked links(String chosen, long now) {
        return agents.links(chosen, now);
    }

    /// From now on it is noted who hears whom, as somebody will look.
    ///
    /// @param now in real time [ns]
    void noteLinks(long now) {
        agents.noteLinks(now);
    }

    /// @param time since the run's start
    /// @param now in real time [ns]
    FinalState lastLook(Duration time, long now) {
        return FinalState.at(this, team.robots().values(), agents.names(), time, now);
    }

    /// Looks after what people began and did not end.
    ///
    /// @param now in real time [ns]
    void beat(long now) {
        robotCommands.beat(now);
        agents.beat(now);
    }

    /// Starts another agent like one.
    ///
    /// @param robot that it is to act for; empty for none
    Answer addAgent(String like, String robot) {
        Optional<PlannedAgent> example = agents.planned(like);
        if (example.isEmpty()) {
            return agents.notRunning(like);
        }
        if (example.get().robot().isPresent() == robot.isEmpty()) {
            return new Answer.Refused(
                    robot.isEmpty()
                            ? "Agent '%s' has a robot, and another one like it needs one.".formatted(like)
                            : "Agent '%s' has no robot, and neither has another one like it.".formatted(like));
        }
        if (!robot.isEmpty() && !team.has(robot)) {
            return world.unknown(robot);
        }
        PlannedAgent another =
                dynamicRobots.another(example.get(), Optional.of(robot).filter(id -> !id.isEmpty()));
        return start(another, "started, like " + like);
    }

    /// Starts an agent of a type.
    ///
    /// @param robot that it is to act for; empty for none
    /// @param typed its arguments, as somebody typed them
    Answer newAgent(String type, String robot, Map<String, String> typed) {
        Optional<Robot> body = team.robot(robot);
        if (!robot.isEmpty() && body.isEmpty()) {
            return world.unknown(robot);
        }
        try {
            List<Robot> all = List.copyOf(team.robots().values());
            PlannedAgent wanted = TypedAgent.read(type, body, typed, all, plan.seed());
            return start(dynamicRobots.another(wanted, wanted.robot()), "started, as " + type);
        } catch (IllegalArgumentException e) {
            return new Answer.Refused(String.valueOf(e.getMessage()));
        }
    }

    private Answer start(PlannedAgent agent, String how) {
        String words = how + agent.robot().map(robot -> ", for " + robot).orElse("");
        Answer answer = agents.start(agent, words, new Answer.Added(agent.name()));
        if (answer instanceof Answer.Added) {
            dynamicRobots.took(agent);
        }
        return answer;
    }

    /// Starts an agent again that has ended.
    Answer startAgent(String name) {
        return agents.planned(name)
                .map(agent -> agents.start(agent, "started again", new Answer.Done()))
                .orElseGet(() -> agents.notRunning(name));
    }

    Answer stopAgent(String name) {
        return agents.stop(name);
    }

    /// @param to name of an agent; empty for all
    Answer say(String to, String topic, Map<String, String> typed) {
        return agents.say(to, topic, typed);
    }

    /// Where robots are now, in the frame `map`, by name; without those of which nobody knows.
    Map<String, Pose2d> poses() {
        var poses = new LinkedHashMap<String, Pose2d>();
        team.robots()
                .keySet()
                .forEach(robot -> where.mapFromBase(robot).ifPresent(mapFromBase -> poses.put(robot, mapFromBase)));
        return poses;
    }

    /// What went wrong with those agents that have failed, by name.
    Map<String, String> failedAgents() {
        return agents.failed();
    }

    /// Goals for which agents had no plan at all, by their names.
    Map<String, List<String>> unhandledGoals() {
        return agents.unhandledGoals();
    }

    /// What agents say all the time.
    ChattyTopics routine() {
        return eventLog.routine();
    }

    List<TopicTraffic> topics() {
        return traffic.topics();
    }

    /// Who heard what so far, where communication is limited.
    List<Reception> hearings() {
        return traffic.hearings();
    }

    /// Those that are there, by id.
    Map<String, Robot> robots() {
        return team.robots();
    }

    /// The truth of the world; empty when no robot is simulated.
    Optional<SimulationControl> simulation() {
        return systems.simulation();
    }

    /// All robots that are or were there.
    List<Teammate> team() {
        return team.mates();
    }

    @Override
    public void close() {
        closed = true;
        bridges.close();
        deviceFactory.close();
        try (systems) {
            agents.close();
        }
    }
}
