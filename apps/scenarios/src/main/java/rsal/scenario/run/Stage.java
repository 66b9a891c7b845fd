package rsal.scenario.run;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentSpec;
import rsal.agent.Message;
import rsal.agent.Society;
import rsal.agent.message.Caught;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.behavior.Pilot;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Twist2d;
import rsal.device.Actuator;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.FiducialFinder;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Light;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Standing;
import rsal.device.SonarArray;
import rsal.device.Subscription;
import rsal.fault.Fault;
import rsal.fault.FaultInjection;
import rsal.fault.FaultyLocalizer;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scenario.PlannedFault;
import rsal.scenario.PlannedFault.OfRobot;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.system.RobotSystem;
import rsal.time.Scheduler;

/// Everything that takes part in a run, put together after the plan: the robots of the robot system, their
/// software devices, the agents. All calls on the run's thread.
final class Stage implements AutoCloseable {
    private static final Duration DISCOVERY_LIMIT = Duration.ofSeconds(10);
    private static final int LAST_MESSAGES = 5;
    private static final int MOST_ADDED = 1000; // things by hand at once, and robots in a run

    /// What a device can be, the most special first.
    private static final List<Class<? extends Device>> CONTRACTS = List.of(
            DriveBase.class,
            LaserScanner.class,
            SonarArray.class,
            BlobFinder.class,
            FiducialFinder.class,
            Gripper.class,
            Bumper.class,
            Actuator.class,
            Battery.class,
            Light.class,
            Localizer.class,
            Navigator.class,
            Planner.class,
            Pilot.class,
            SimulationControl.class);

    private static final Covariance2d PLACED_BY_HAND = Covariance2d.ofDeviations(0.1, 0.1, Math.toRadians(5));

    private final RunPlan plan;
    private final Scheduler scheduler;
    private final Journal journal;
    private final Observer observer;
    private final RobotSystem system;
    private final Faults faults;
    private final Set<String> breaking; // all that faults can strike, by name
    private final Map<String, FaultyLocalizer> faultyLocalizers = new HashMap<>(); // by the device's id
    private final Map<String, Robot> robots = new LinkedHashMap<>();
    private final Map<String, Controls> controls = new LinkedHashMap<>();
    private final Map<String, Deque<Message<?>>> lastMessages = new HashMap<>();
    private final Map<String, String> lastWords = new HashMap<>();
    private final Placements placements = new Placements();
    private final Map<String, Pose2d> mapFromAsked = new HashMap<>(); // where the operator wants robots
    private final Newcomers newcomers;
    private final Map<String, List<GuardedScheduler>> lanes = new HashMap<>(); // of software devices, by robot
    private final Set<String> props = new HashSet<>(); // things that were added by hand and are there
    private List<Teammate> team = List.of();
    private int robotsAdded; // by hand
    private Optional<String> like = Optional.empty(); // which robot the one is made after that comes now
    private Optional<Society> society = Optional.empty();
    private boolean stopped;
    private boolean closed;

    /// Makes the robot system; nothing moves yet.
    Stage(RunPlan plan, Scheduler scheduler, Journal journal, Observer observer) {
        this.plan = plan;
        this.scheduler = scheduler;
        this.journal = journal;
        this.observer = observer;
        this.newcomers = new Newcomers(plan);
        this.system = named(
                systemName(),
                () -> plan.mrs()
                        .provider()
                        .create(
                                plan.mrs().config(plan.scene(), plan.robots()),
                                new GuardedScheduler(systemName(), scheduler)));
        this.breaking = plan.faults().stream()
                .flatMap(fault -> fault.targets().stream())
                .map(PlannedFault.Target::name)
                .collect(Collectors.toSet());
        this.faults = new Faults(plan, scheduler, journal, observer, new Faults.Breaker() {
            @Override
            public Optional<String> refusal(OfRobot broken) {
                return faultyLocalizers.containsKey(broken.name())
                        ? Optional.empty()
                        : injection().refusal(broken.robot(), broken.device(), broken.fault());
            }

            @Override
            public Subscription begin(OfRobot broken, RandomGenerator random) {
                return breakDown(broken, random);
            }
        });
    }

    /// Finds the robots and, once they are there, begins.
    void begin() {
        scheduler
                .within(DISCOVERY_LIMIT, named(systemName(), system::discover))
                .whenComplete((found, error) -> scheduler.execute(() -> {
                    if (error != null) {
                        throw new RunBroken(systemName(), error);
                    }
                    assemble(found);
                }));
    }

    private String systemName() {
        return "Robot system (%s)".formatted(plan.mrs().provider().key());
    }

    private void assemble(List<Robot> found) {
        for (PlannedRobot planned : plan.robots()) {
            String id = planned.spec().id();
            Robot robot = found.stream()
                    .filter(r -> r.id().equals(id))
                    .findFirst()
                    .orElseThrow(() -> new RunBroken("%s has no robot (%s); it has %s."
                            .formatted(
                                    systemName(),
                                    id,
                                    found.stream().map(Robot::id).toList())));
            equip(robot, planned);
        }
        system.onChange(this::changed);
        startAgents();
    }

    private void equip(Robot bare, PlannedRobot planned) {
        Optional<Helm> helm = bare.find(DriveBase.class).map(Helm::new);
        Robot robot = helm.map(own -> own.steering(bare, Helm.Hand.AGENTS)).orElse(bare);
        Optional<Pose2d> start = planned.spec().mapFromBase();
        for (PlannedDevice device : planned.drivers()) {
            robot = robot.with(breakable(make(device, robot, start)));
        }
        robots.put(robot.id(), robot);
        include(new Teammate(planned.spec(), system.simulation().flatMap(truth -> truth.body(bare.id()))));
        robot.devices().forEach(this::watch);
        if (helm.isPresent()) {
            Controls.Maker spares = (device, made) -> makeSpare(device, made, start);
            controls.put(robot.id(), new Controls(robot, helm.get(), planned.spares(), spares, journal));
        }
    }

    /// One that was there before keeps its place.
    private void include(Teammate mate) {
        var grown = new LinkedHashMap<String, Teammate>();
        team.forEach(other -> grown.put(other.spec().id(), other));
        grown.put(mate.spec().id(), mate);
        team = List.copyOf(grown.values());
    }

    /// Makes a device in the middle of the run. It begins where the robot is now, as if somebody had placed it there.
    ///
    /// @param start where it was at first, for when nobody knows where it is now
    private Device makeSpare(PlannedDevice device, Robot robot, Optional<Pose2d> start) {
        Optional<Pose2d> now = system.simulation().flatMap(truth -> truth.truth(robot.id()));
        Device made = make(device, robot, now.or(() -> start));
        watch(made);
        return made;
    }

    private Device make(PlannedDevice device, Robot robot, Optional<Pose2d> mapFromBase) {
        String name = "Device (%s/%s)".formatted(robot.id(), device.name());
        var lane = new GuardedScheduler(name, scheduler);
        lanes.computeIfAbsent(robot.id(), _ -> new ArrayList<>()).add(lane);
        var context = new DeviceDriver.Context(
                device.name(), robot, plan.map(), mapFromBase, lane, new SplittableRandom(device.seed()));
        return named(name, () -> device.driver().create(context, device.options()));
    }

    /// A localizer that can have a fault later, if there will be one.
    private Device breakable(Device device) {
        String id = device.info().id();
        if (breaking.contains(id) && device instanceof Localizer localizer) {
            var faulty = new FaultyLocalizer(localizer);
            faultyLocalizers.put(id, faulty);
            return faulty;
        }
        return device;
    }

    private Subscription breakDown(OfRobot broken, RandomGenerator random) {
        FaultyLocalizer localizer = faultyLocalizers.get(broken.name());
        if (localizer != null && broken.fault() instanceof Fault.OfSensor ofSensor) {
            return localizer.begin(ofSensor, random);
        }
        return injection().begin(broken.robot(), broken.device(), broken.fault(), random);
    }

    private FaultInjection injection() {
        return system.faults().orElseThrow();
    }

    /// Does what may fail; then its owner is to blame.
    private static <T> T named(String owner, Supplier<T> work) {
        try {
            return work.get();
        } catch (RuntimeException | Error e) {
            throw new RunBroken(owner, e);
        }
    }

    private void watch(Device device) {
        device.onHealth(health -> {
            if (!closed && robots.containsKey(device.info().robot())) {
                journal.event("health", device.info().id(), Words.of(health));
            }
        });
    }

    private void changed(RobotSystem.Change change) {
        if (closed) {
            return;
        }
        switch (change) {
            case RobotSystem.Change.Appeared(Robot robot) -> {
                journal.event("run", robot.id(), "is there");
                if (!robots.containsKey(robot.id())) {
                    join(robot);
                }
            }
            case RobotSystem.Change.Gone(String robot, String reason) -> {
                if (!faults.isGone(robot)) { // else that was told
                    journal.event("fault", robot, "is gone: " + reason);
                }
            }
            case RobotSystem.Change.Removed(String robot) -> {
                journal.event("run", robot, "was removed");
                leave(robot);
            }
        }
    }

    /// Gives a robot that nobody planned what those like it have.
    private void join(Robot robot) {
        String id = robot.id();
        PlannedRobot planned = newcomers.plan(robot, like, system.simulation().flatMap(truth -> truth.truth(id)));
        observer.joined(id, robot.role());
        equip(robot, planned);
        if (stopped) {
            Optional.ofNullable(controls.get(id)).ifPresent(Controls::stop);
        }
        society.ifPresent(agents -> newcomers.agents(id).forEach(agent -> start(agents, agent)));
    }

    /// Lets go of all that a robot had: its agents end as they would at the end of the run.
    private void leave(String id) {
        robots.remove(id);
        controls.remove(id);
        mapFromAsked.remove(id);
        society.ifPresent(agents -> agents.directory().agents().stream()
                .filter(agent -> agent.robot().equals(id))
                .forEach(agent -> agents.stop(agent.name())));
        Optional.ofNullable(lanes.remove(id)).ifPresent(all -> all.forEach(GuardedScheduler::end));
    }

    private void startAgents() {
        AgentHostProvider provider = plan.mas().provider();
        AgentHost host = named(
                "Multi-agent system (%s)".formatted(provider.key()),
                () -> provider.create(plan.mas().settings(), scheduler));
        var agents = new Society(scheduler, host, system.simulation());
        society = Optional.of(agents);
        agents.onMessage(this::heard);
        agents.onChange(this::changed);
        if (!plan.faults().isEmpty()) {
            agents.deliverBy(faults.delivery());
            faults.begin();
        }
        plan.agents().forEach(agent -> start(agents, agent));
        journal.event(
                "run",
                "",
                "%d robots, %d agents".formatted(robots.size(), plan.agents().size()));
    }

    private void start(Society agents, PlannedAgent agent) {
        agents.start(new AgentSpec(
                agent.name(),
                agent.role(),
                agent.type(),
                agent.arguments(),
                agent.robot().map(robots::get),
                agent.seed()));
    }

    private void heard(Message<?> message) {
        if (closed || faults.isSilent(message.sender())) {
            return;
        }
        var last = lastMessages.computeIfAbsent(message.sender(), _ -> new ArrayDeque<>());
        last.addLast(message);
        if (last.size() > LAST_MESSAGES) {
            last.removeFirst();
        }
        String words = Words.of(message);
        switch (message.content()) {
            case PoseReport _, PoseRequest _ ->
                journal.hash(message.sender(), message.topic().name(), words);
            case NewGoal _ -> journal.event("goal", message.sender(), words);
            case GoalReached end -> {
                journal.event("goal", message.sender(), words);
                ended(end);
            }
            case Caught caught -> {
                journal.event("caught", message.sender(), words);
                observer.heard(caught, system.simulation());
            }
            default -> journal.event("message", message.sender(), words);
        }
    }

    /// The operator hears when a robot did not get where it was sent last. A goal that is cancelled has given way
    /// to another, maybe to the same place again.
    private void ended(GoalReached end) {
        if (end.ending().equals("cancelled") || !end.mapFromGoal().equals(mapFromAsked.get(end.robot()))) {
            return;
        }
        mapFromAsked.remove(end.robot());
        if (!end.ending().equals("reached")) {
            journal.event(
                    "unreached",
                    end.robot(),
                    "can't get to %s: %s".formatted(Words.of(end.mapFromGoal()), end.ending()));
        }
    }

    private void changed(Society.View view) {
        String words = switch (view.status()) {
            case RUNNING -> view.state().isEmpty() ? "has started" : view.state();
            case ENDED -> "has ended";
            case FAILED -> "has failed: " + view.state();
        };
        String name = view.agent().name();
        if (!closed && !words.equals(lastWords.put(name, words))) {
            journal.event(view.status() == Society.Status.FAILED ? "fault" : "agent", name, words);
        }
    }

    /// Looks at everything after a step.
    ///
    /// @return how the run ends, if it is over
    Optional<String> observe() {
        return observer.look(system.simulation(), robots);
    }

    /// Whether robots and agents are there.
    boolean isReady() {
        return society.isPresent();
    }

    boolean stopped() {
        return stopped;
    }

    List<RobotView> robotViews() {
        return team.stream()
                .map(Teammate::spec)
                .flatMap(spec -> Optional.ofNullable(robots.get(spec.id())).map(robot -> view(spec, robot)).stream())
                .toList();
    }

    private RobotView view(RobotSpec spec, Robot robot) {
        String id = robot.id();
        boolean there = !faults.isGone(id) && !isNowhere(id);
        Optional<Controls> told = Optional.ofNullable(controls.get(id));
        Optional<Localizer> localizer = localizer(robot).filter(_ -> there && placements.isBeliefOfHere(id));
        Optional<Navigator> navigator = told.flatMap(orders -> orders.outfit().find(Navigator.class))
                .filter(spare -> spare.goal().isPresent())
                .or(() -> robot.find(Navigator.class))
                .filter(_ -> there);
        return new RobotView(
                id,
                robot.role(),
                spec.color(),
                robot.model().name(),
                system.simulation().flatMap(truth -> truth.truth(id)),
                robot.find(DriveBase.class).filter(_ -> there).flatMap(DriveBase::latest),
                localizer.flatMap(Localizer::latest).filter(estimate -> placements.isOfHere(id, estimate)),
                localizer.flatMap(Localizer::particles).filter(cloud -> placements.isOfHere(id, cloud)),
                robot.find(LaserScanner.class)
                        .flatMap(LaserScanner::latest)
                        .filter(scan -> there && placements.isOfHere(id, scan)),
                robot.find(SonarArray.class)
                        .flatMap(SonarArray::latest)
                        .filter(ranges -> there && placements.isOfHere(id, ranges)),
                navigator.map(Navigator::path).orElse(Path2d.EMPTY),
                navigator.flatMap(Navigator::goal),
                told.map(Controls::incharge)
                        .orElse(Optional.of(robot))
                        .map(Stage::inCharge)
                        .orElse(""),
                told.map(Controls::behavior).orElse(""),
                told.map(Controls::driver).orElse(""),
                robot.find(Gripper.class).filter(_ -> there).flatMap(Gripper::latest),
                robot.find(Light.class)
                        .filter(_ -> there)
                        .flatMap(Light::latest)
                        .filter(light -> light.value().lit())
                        .isPresent(),
                devices(robot).stream().map(Stage::view).toList());
    }

    /// Its own, or else one that it was given to do what people told it.
    private Optional<Localizer> localizer(Robot robot) {
        return robot.find(Localizer.class)
                .or(() -> Optional.ofNullable(controls.get(robot.id()))
                        .flatMap(told -> told.outfit().find(Localizer.class)));
    }

    /// Its own, and those besides that are of another name.
    private List<Device> devices(Robot robot) {
        var all = new LinkedHashMap<String, Device>();
        robot.devices().forEach(device -> all.put(device.info().name(), device));
        Optional.ofNullable(controls.get(robot.id()))
                .ifPresent(told -> told.made()
                        .forEach(device -> all.putIfAbsent(device.info().name(), device)));
        return List.copyOf(all.values());
    }

    /// Gone from the simulated world: what it believed there is not shown.
    private boolean isNowhere(String robot) {
        return system.simulation().filter(truth -> truth.truth(robot).isEmpty()).isPresent();
    }

    private static DeviceView view(Device device) {
        return new DeviceView(device.info().name(), device.info().driver(), type(device), device.health());
    }

    /// The contract that it fulfils: `LaserScanner`.
    private static String type(Device device) {
        return CONTRACTS.stream()
                .filter(contract -> contract.isInstance(device))
                .map(Class::getSimpleName)
                .findFirst()
                .orElse("Device");
    }

    /// An engaged pilot comes first: it commands the base, whatever goal the navigator still has.
    private static String inCharge(Robot robot) {
        return robot.find(Pilot.class)
                .filter(Pilot::engaged)
                .flatMap(Pilot::latest)
                .map(decision -> decision.value().inCharge())
                .or(() -> robot.find(Navigator.class)
                        .filter(navigator -> navigator.goal().isPresent() && !navigator.paused())
                        .map(navigator -> navigator.info().name()))
                .orElse("");
    }

    List<AgentView> agentViews() {
        return society.stream()
                .flatMap(agents -> agents.views().stream())
                .map(view -> new AgentView(view, lastMessages(view.agent().name())))
                .toList();
    }

    private List<String> lastMessages(String agent) {
        return lastMessages.getOrDefault(agent, new ArrayDeque<>()).stream()
                .map(message -> message.topic().name() + ": " + Words.of(message))
                .toList();
    }

    /// All robots that are or were there.
    List<Teammate> team() {
        return team;
    }

    List<Standing> things() {
        return system.simulation().map(SimulationControl::things).orElse(List.of());
    }

    /// Puts a robot somewhere, in truth and in its own belief, or a thing.
    Answer place(String id, Pose2d mapFromBase) {
        Robot robot = robots.get(id);
        if (robot == null) {
            return placeThing(id, mapFromBase);
        }
        if (isNowhere(id)) {
            return new Answer.Refused("Robot (%s) is gone.".formatted(id));
        }
        OccupancyGrid map = plan.map();
        if (!mapFromBase.isFinite() || !map.contains(map.column(mapFromBase.x()), map.row(mapFromBase.y()))) {
            return new Answer.Refused("%s is outside the map.".formatted(Words.of(mapFromBase)));
        }
        Optional<SimulationControl> simulation = system.simulation();
        if (simulation.isPresent()
                && simulation.get().place(id, mapFromBase) instanceof SimulationControl.Placement.Refused(String why)) {
            return new Answer.Refused(why);
        }
        observer.placed(id);
        CompletableFuture<Void> believed = localizer(robot)
                .map(localizer -> localizer.relocalize(PoseEstimate.of(mapFromBase, PLACED_BY_HAND)))
                .map(CompletionStage::toCompletableFuture)
                .orElse(CompletableFuture.completedFuture(null));
        if (simulation.isPresent()) {
            placements.add(id, scheduler.instant(), believed);
        }
        journal.event("operator", id, "placed at " + Words.of(mapFromBase));
        return new Answer.Done();
    }

    private Answer placeThing(String name, Pose2d mapFromThing) {
        if (things().stream().noneMatch(thing -> thing.name().equals(name))) {
            return unknown(name);
        }
        return answer(
                system.simulation().orElseThrow().place(name, mapFromThing),
                name,
                "placed at " + Words.of(mapFromThing),
                new Answer.Done());
    }

    /// Journals what an operator did to the simulated world, if it was done.
    private Answer answer(SimulationControl.Placement placement, String name, String words, Answer done) {
        if (placement instanceof SimulationControl.Placement.Refused(String why)) {
            return new Answer.Refused(why);
        }
        journal.event("operator", name, words);
        return done;
    }

    /// Puts something new into the world.
    Answer add(Prop prop, Pose2d mapFromThing) {
        Optional<SimulationControl> simulation = system.simulation();
        if (simulation.isEmpty()) {
            return nothingSimulated();
        }
        var taken = new HashSet<>(simulation.get().entities());
        props.retainAll(taken);
        if (props.size() == MOST_ADDED) {
            return new Answer.Refused("%d things were added already; remove some first.".formatted(MOST_ADDED));
        }
        String name = prop.name(taken);
        Answer answer = answer(
                simulation.get().add(prop.at(name, mapFromThing)),
                name,
                "added at " + Words.of(mapFromThing),
                new Answer.Added(name));
        if (answer instanceof Answer.Added) {
            props.add(name);
        }
        return answer;
    }

    /// Puts another robot into the world.
    Answer addRobot(String example, Pose2d mapFromBase) {
        Optional<SimulationControl> simulation = system.simulation();
        if (simulation.isEmpty()) {
            return nothingSimulated();
        }
        if (robotsAdded == MOST_ADDED) {
            return new Answer.Refused("%d robots were added already; that is enough for a run.".formatted(MOST_ADDED));
        }
        Optional<String> id =
                newcomers.idLike(example, new HashSet<>(simulation.get().entities()));
        if (id.isEmpty()) {
            return unknown(example);
        }
        like = Optional.of(example);
        Answer answer = answer(
                simulation.get().addRobot(id.get(), example, mapFromBase),
                id.get(),
                "added at " + Words.of(mapFromBase),
                new Answer.Added(id.get()));
        like = Optional.empty();
        robotsAdded += answer instanceof Answer.Added ? 1 : 0;
        return answer;
    }

    /// Takes a robot or a thing out of the world.
    Answer remove(String entity) {
        Optional<SimulationControl> simulation = system.simulation();
        if (simulation.isEmpty()) {
            return nothingSimulated();
        }
        boolean removed = robots.containsKey(entity)
                ? simulation.get().removeRobot(entity)
                : simulation.get().remove(entity);
        if (!removed) {
            return unknown(entity);
        }
        props.remove(entity);
        journal.event("operator", entity, "removed");
        return new Answer.Done();
    }

    private Answer nothingSimulated() {
        return new Answer.Refused("%s simulates no world that could be changed.".formatted(systemName()));
    }

    /// Has a robot drive somewhere: its agent, if it has one and a navigator.
    Answer goTo(String id, Pose2d mapFromGoal) {
        Robot robot = robots.get(id);
        if (robot == null) {
            return unknown(id);
        }
        if (faults.isGone(id)) {
            return gone(id);
        }
        if (!plan.map().isFree(mapFromGoal.x(), mapFromGoal.y())) {
            return new Answer.Refused("There is a wall or nothing known at %s.".formatted(Words.of(mapFromGoal)));
        }
        boolean agentDrives = robot.find(Navigator.class).isPresent()
                && society.orElseThrow().directory().agents().stream()
                        .anyMatch(agent -> agent.robot().equals(id));
        return agentDrives ? askAgent(id, mapFromGoal) : tell(id, told -> told.goTo(mapFromGoal));
    }

    private Answer askAgent(String id, Pose2d mapFromGoal) {
        Optional<Answer> refused = Optional.ofNullable(controls.get(id)).flatMap(Controls::leave);
        if (refused.isPresent()) {
            return refused.get();
        }
        journal.event("operator", id, "sent to " + Words.of(mapFromGoal));
        mapFromAsked.put(id, mapFromGoal);
        society.orElseThrow().publish("operator", NewGoal.TOPIC, new NewGoal(id, mapFromGoal));
        return new Answer.Done();
    }

    Answer abilities(String id) {
        return tell(id, told -> new Answer.Able(told.abilities()));
    }

    Answer behave(String id, String behavior) {
        return tell(id, told -> told.behave(behavior));
    }

    /// @param heard when its driver said so [ns]
    Answer drive(String id, String driver, Twist2d velocity, long heard) {
        return velocity.isFinite()
                ? tell(id, told -> told.drive(driver, velocity, heard, !stopped))
                : new Answer.Refused("A velocity must be finite, not (%s).".formatted(velocity));
    }

    Answer letGo(String id, String driver) {
        return tell(id, told -> told.letGo(driver));
    }

    private Answer tell(String id, Function<Controls, Answer> order) {
        if (!robots.containsKey(id)) {
            return unknown(id);
        }
        if (faults.isGone(id)) {
            return gone(id);
        }
        Controls told = controls.get(id);
        return told == null ? new Answer.Refused("Robot (%s) has no drive.".formatted(id)) : order.apply(told);
    }

    private static Answer gone(String id) {
        return new Answer.Refused("Robot (%s) is gone.".formatted(id));
    }

    /// Lets those who are driven by hand go on, as long as their drivers are heard.
    ///
    /// @param now [ns]
    void beat(long now) {
        controls.values().forEach(told -> told.beat(now));
    }

    private Answer unknown(String id) {
        return new Answer.Refused("There is no (%s); there are the robots %s and %d other things."
                .formatted(id, robots.keySet(), things().size()));
    }

    /// Switches all motors off or on again.
    Answer stop(boolean stop) {
        stopped = stop;
        List.copyOf(controls.values()).forEach(stop ? Controls::stop : Controls::rearm);
        journal.event("operator", "", stop ? "emergency stop" : "motors on again");
        return new Answer.Done();
    }

    @Override
    public void close() {
        closed = true;
        try (system) {
            society.ifPresent(Society::close);
        }
    }
}
