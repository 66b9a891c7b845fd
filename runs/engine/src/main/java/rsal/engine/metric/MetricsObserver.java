package rsal.engine.metric;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.data.Walls;
import rsal.device.Battery;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Contact;
import rsal.engine.event.EventLog;
import rsal.engine.event.RunClock;
import rsal.engine.report.RunBroken;
import rsal.engine.robot.RobotPoses;
import rsal.metric.NameKind;
import rsal.metric.QuantityType;
import rsal.metric.RobotState;
import rsal.metric.SignalType;
import rsal.robot.Robot;
import rsal.scenario.PlannedMetric;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.MetricDefinition;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.condition.Facts;
import rsal.scenario.condition.MetricExpression;
import rsal.scenario.condition.Quantity;
import rsal.scenario.condition.RunQuantities;

/// Looks at a run after each step: is it over, and what is there to measure? It alone compares robots with the
/// truth. All calls on the run's thread.
public final class MetricsObserver implements Facts {
    private final RunPlan plan;
    private final EventLog eventLog;
    private final RunClock clock;
    private final Map<String, RobotRecord> records = new LinkedHashMap<>();
    private final Map<MetricDefinition, OptionalDouble> firstTimes = new HashMap<>();
    private final Map<String, Pose2d> sentTo = new HashMap<>(); // by robot, or ALL
    private final Set<String> arrived = new HashSet<>(); // where they were sent last
    private boolean counting; // touches
    private int contacts;
    private RunPlan.@Nullable Stop decided;
    private Duration endsAt = Duration.ZERO;
    private long wallCollisions;
    private long faults;
    private final MessageCounts said;
    private final MessageCounts heard;
    private final MessageCounts lost;
    private final Map<Quantity, Samples> quantities = new LinkedHashMap<>(); // after each step
    private final Published published;
    private final PositionMetrics positions;
    private final boolean asksForPositions;
    private Set<String> gone = Set.of(); // robots
    private @Nullable RobotPoses where;
    private Supplier<Optional<SimulationControl>> simulation = Optional::empty;
    private @Nullable RunBroken broken; // by a metric
    private final DepotMetrics depots;
    private final ReachedMetrics reached;
    private final MappingMetrics mapped;
    private final Map<String, ToDoubleFunction<List<String>>> values = new HashMap<>(); // by word of a quantity
    private final Map<String, NamedMetric> offered = new HashMap<>(); // by words of their quantities
    private final List<NamedMetric> observing = new ArrayList<>();
    private final Map<String, Samples> ofRun = new HashMap<>(); // by word of a signal
    private final ObservedRun run;
    private final boolean asksForShare;
    private final Map<String, Stamped<OccupancyGrid>> maps = new LinkedHashMap<>(); // of the world, by robot
    private final Map<String, Boolean> exploring = new LinkedHashMap<>(); // by robot that draws a map
    private final Set<String> started = new LinkedHashSet<>(); // of these

    public MetricsObserver(RunPlan plan, EventLog eventLog, RunClock clock) {
        this.plan = plan;
        this.eventLog = eventLog;
        this.clock = clock;
        for (PlannedRobot robot : plan.robots()) {
            records.put(robot.spec().id(), new RobotRecord(robot.spec().role()));
            if (robot.drivers().stream()
                    .anyMatch(
                            made -> Mapper.class.isAssignableFrom(made.driver().makes()))) {
                exploring.put(robot.spec().id(), true); // even before it is there
            }
        }
        this.depots = new DepotMetrics(plan.things(), eventLog);
        var walls = new Walls(plan.map());
        this.reached = new ReachedMetrics(plan.things(), walls, eventLog);
        this.mapped = new MappingMetrics(plan.map(), radius(plan));
        this.run = new ObservedRun(this, walls, eventLog, plan.things());
        List<Quantity> asked = Stream.concat(
                        plan.stops().stream().flatMap(stop -> stop.when().quantities()),
                        plan.metrics().stream()
                                .flatMap(measured -> measured.from().quantities()))
                .toList();
        this.asksForShare = asked.stream().anyMatch(quantity -> quantity.type().equals(RunQuantities.EXPLORED));
        this.asksForPositions = asked.stream().map(Quantity::type).anyMatch(PositionMetrics.QUANTITIES::contains);
        this.positions = new PositionMetrics(plan.places());
        this.said = new MessageCounts(names(asked, RunQuantities.MESSAGES));
        this.heard = new MessageCounts(names(asked, RunQuantities.HEARD_MESSAGES));
        this.lost = new MessageCounts(names(asked, RunQuantities.LOST_MESSAGES));
        this.published = new Published(names(asked, RunQuantities.METRIC));
        for (MetricDefinition measured : plan.metrics()) {
            if (measured.from() instanceof MetricExpression.OfQuantity of && !of.isPublished()) {
                quantities.put(of.quantity(), new Samples());
            }
        }
        offerOwn();
        for (PlannedMetric planned : plan.metricTypes()) {
            var metric = NamedMetric.of(planned, run);
            observing.add(metric);
            for (QuantityType type : planned.type().quantities()) {
                offered.put(type.word(), metric);
                offer(type, names -> metric.value(type.word(), names));
            }
        }
    }

    /// What each run knows of itself: all of [RunQuantities].
    private void offerOwn() {
        offer(RunQuantities.TIME, _ -> time());
        offer(RunQuantities.COLLISIONS, _ -> counting ? contacts : Double.NaN);
        offer(RunQuantities.WALL_COLLISIONS, _ -> counting ? wallCollisions : Double.NaN);
        offer(RunQuantities.ARRIVED, names -> among(arrived, names.getFirst()));
        offer(RunQuantities.GONE, names -> among(gone, names.getFirst()));
        offer(RunQuantities.FAULTS, _ -> faults);
        offer(RunQuantities.MESSAGES, said::of);
        offer(RunQuantities.HEARD_MESSAGES, heard::of);
        offer(RunQuantities.LOST_MESSAGES, lost::of);
        offer(RunQuantities.EXPLORED, _ -> mapped.share(maps.values()));
        offer(RunQuantities.EXPLORING, names -> exploring(names.getFirst()));
        offer(RunQuantities.COLLECTED, names -> depots.collected(names.getFirst()));
        offer(RunQuantities.REACHED, names -> reached.reached(names.getFirst()));
        offer(RunQuantities.DISTANCE, names -> positions.distance(names.getFirst(), names.get(1)));
        offer(RunQuantities.WITHIN, names -> positions.within(names.getFirst(), names.get(1)));
        offer(RunQuantities.VISITS, names -> positions.visits(names.getFirst(), names.get(1)));
        offer(RunQuantities.METRIC, names -> published.newest(names.getFirst()));
    }

    private void offer(QuantityType type, ToDoubleFunction<List<String>> value) {
        values.put(type.word(), value);
    }

    /// Says where robots and things are, before the first step.
    public void attach(RobotPoses poses, Supplier<Optional<SimulationControl>> simulated) {
        where = poses;
        simulation = simulated;
    }

    /// Where a robot is, or was last.
    Optional<RobotState> robot(String id) {
        return Optional.ofNullable(records.get(id)).map(known -> robot(id, known));
    }

    private RobotState robot(String id, RobotRecord known) {
        RobotPoses poses = Objects.requireNonNull(where, "A run is attached before it begins.");
        return new RobotState(
                id, known.role(), poses.mapFromBase(id), poses.truth(id).isPresent());
    }

    /// Those that are not gone.
    List<RobotState> robots() {
        var there = new ArrayList<RobotState>();
        records.forEach((id, known) -> {
            if (!gone.contains(id)) {
                there.add(robot(id, known));
            }
        });
        return there;
    }

    /// The simulated world; empty without one.
    Optional<SimulationControl> simulation() {
        return simulation.get();
    }

    /// Notes a sample of the whole run.
    void sample(SignalType signal, double value) {
        ofRun.computeIfAbsent(signal.word(), _ -> new Samples()).add(time(), value);
    }

    /// Notes a sample of one robot.
    void sample(SignalType signal, String robot, double value) {
        Optional.ofNullable(records.get(robot)).ifPresent(known -> known.sample(signal, value, time()));
    }

    /// Those by which one quantity is asked for.
    private static List<String> names(List<Quantity> asked, QuantityType type) {
        return asked.stream()
                .filter(quantity -> quantity.type().equals(type))
                .flatMap(quantity -> quantity.names().stream())
                .distinct()
                .toList();
    }

    /// Of the slimmest robot.
    private static double radius(RunPlan plan) {
        return plan.robots().stream()
                .mapToDouble(robot -> robot.spec().model().footprint().circumscribedRadius())
                .min()
                .orElse(0);
    }

    /// Looks at everything once.
    ///
    /// @param robots by id, as far as they are there
    /// @return how the run ends, if it is over
    /// @throws RunBroken when a metric has failed
    public Optional<String> look(Map<String, Robot> robots) {
        if (broken != null) {
            throw broken;
        }
        RobotPoses poses = Objects.requireNonNull(where, "A run is attached before it begins.");
        Optional<SimulationControl> world = simulation.get();
        world.ifPresent(truth -> noteContacts(truth.contacts()));
        counting = counting || robots.keySet().stream().anyMatch(poses::isSimulated);
        if (depots.areThere()) {
            world.ifPresent(truth -> depots.look(truth.things()));
        }
        List<ReachedMetrics.There> there = reached.isWanted() || asksForPositions ? there(poses) : List.of();
        if (reached.isWanted()) {
            world.ifPresent(truth -> reached.look(truth.things(), there, time()));
        }
        if (asksForPositions) {
            positions.look(there);
        }
        observing.forEach(NamedMetric::onStep);
        records.forEach((id, own) -> {
            poses.truth(id).ifPresent(mapFromBase -> {
                eventLog.hash(mapFromBase);
                own.moved(clock.instant(), mapFromBase);
            });
            Optional<Robot> robot = Optional.ofNullable(robots.get(id));
            robot.flatMap(its -> its.find(Localizer.class))
                    .flatMap(Localizer::latest)
                    .ifPresent(estimate -> noteEstimate(own, estimate));
            robot.flatMap(its -> its.find(Battery.class))
                    .flatMap(Battery::latest)
                    .ifPresent(battery -> own.charged(battery.value().level(), time()));
            robot.flatMap(its -> its.find(Mapper.class))
                    .ifPresent(mapper -> noteMap(id, mapper, poses.mapFromBase(id)));
        });
        exploring.keySet().removeIf(robot -> started.contains(robot) && !robots.containsKey(robot));
        noteQuantities();
        noteFirstTimes();
        return ending();
    }

    private List<ReachedMetrics.There> there(RobotPoses poses) {
        var there = new ArrayList<ReachedMetrics.There>();
        records.forEach((id, own) -> poses.mapFromBase(id)
                .filter(_ -> !gone.contains(id))
                .ifPresent(mapFromBase -> there.add(new ReachedMetrics.There(id, own.role(), mapFromBase))));
        return there;
    }

    /// The first condition that holds decides the outcome, even if the run then goes on for a while.
    private Optional<String> ending() {
        if (decided == null) {
            plan.stops().stream()
                    .filter(stop -> stop.when().holds(this))
                    .findFirst()
                    .ifPresent(this::decide);
        }
        boolean over = decided != null && elapsed().compareTo(endsAt) >= 0;
        boolean limit =
                plan.options().limit().filter(l -> elapsed().compareTo(l) >= 0).isPresent();
        if (!over && !limit) {
            return Optional.empty();
        }
        return Optional.of(decided == null ? "limit" : decided.outcome().word());
    }

    private void decide(RunPlan.Stop stop) {
        decided = stop;
        endsAt = elapsed().plus(stop.after());
        if (stop.after().isPositive()) {
            eventLog.event(
                    "run",
                    "",
                    stop.outcome().word()
                            + "; goes on for %d s".formatted(stop.after().toSeconds()));
        }
    }

    private void noteContacts(List<Contact> all) {
        for (Contact contact : all.subList(contacts, all.size())) {
            wallCollisions += records.containsKey(contact.other()) ? 0 : 1;
            eventLog.event("collision", contact.robot(), "ran into " + contact.other());
        }
        contacts = all.size();
    }

    private void noteEstimate(RobotRecord own, Stamped<PoseEstimate> estimate) {
        eventLog.hash(estimate.value().mapFromBase());
        own.compare(estimate, time());
    }

    private void noteMap(String robot, Mapper mapper, Optional<Pose2d> mapFromBase) {
        boolean complete = mapper.isComplete();
        boolean first = started.add(robot);
        Boolean before = exploring.put(robot, !complete);
        if (complete && Boolean.TRUE.equals(before)) { // who has a whole map from the beginning has mapped nothing
            eventLog.event("mapped", robot, "has mapped all that it can get to");
        } else if (!complete && Boolean.FALSE.equals(before)) {
            eventLog.event("mapped", robot, "can get to more that is not on its map");
        }
        if (asksForShare && mapFromBase.isPresent()) {
            if (first) {
                mapped.starts(mapFromBase.get().position());
            }
            mapper.latest().filter(map -> map.frame().equals(RobotPoses.WORLD)).ifPresent(map -> maps.put(robot, map));
        }
    }

    private void noteQuantities() {
        quantities.forEach((quantity, samples) -> {
            double value = value(quantity);
            if (!Double.isNaN(value)) {
                samples.add(time(), value);
            }
        });
    }

    private void noteFirstTimes() {
        for (MetricDefinition measured : plan.metrics()) {
            if (measured.from() instanceof MetricExpression.FirstTime(var condition)
                    && !firstTimes.containsKey(measured)
                    && condition.holds(this)) {
                firstTimes.put(measured, OptionalDouble.of(time()));
            }
        }
    }

    /// An agent publishes a value under a name.
    public void published(String agent, Optional<String> robot, String name, double value) {
        published.add(agent, robot, name, value, time());
    }

    /// An agent or the operator has said something.
    ///
    /// @param content of the message; in conversations, what they are about
    public void heard(String sender, Object content) {
        switch (content) {
            case NewGoal order -> heard(order);
            case GoalReached end -> heard(end);
            default -> {} // for metrics
        }
        for (NamedMetric metric : observing) {
            try {
                metric.onMessage(sender, content);
            } catch (RunBroken e) { // not the sender's fault: it ends the run after this step
                broken = broken == null ? e : broken;
            }
        }
    }

    /// Robots are sent somewhere.
    private void heard(NewGoal order) {
        if (order.robot().equals(NewGoal.ALL)) {
            sentTo.replaceAll((_, _) -> order.mapFromGoal());
            arrived.clear();
        }
        sentTo.put(order.robot(), order.mapFromGoal());
        arrived.remove(order.robot());
    }

    /// A drive has ended.
    private void heard(GoalReached end) {
        boolean newest = end.mapFromGoal().equals(sentTo.getOrDefault(end.robot(), sentTo.get(NewGoal.ALL)));
        if (newest && end.reached()) {
            arrived.add(end.robot());
        }
    }

    /// A robot has come. Robots that leave count on, as they were last.
    public void joined(String robot, String role) {
        records.computeIfAbsent(robot, _ -> new RobotRecord(role)).placed();
    }

    public void faultBegan() {
        faults++;
    }

    public void messageSaid(String topic) {
        said.add(topic);
    }

    public void messageHeard(String topic) {
        heard.add(topic);
    }

    public void messageLost(String topic) {
        lost.add(topic);
    }

    /// Robots that are gone now.
    public void gone(Set<String> robots) {
        gone = robots;
    }

    /// A robot is going to be put elsewhere.
    public void placed(String robot) {
        Optional.ofNullable(records.get(robot)).ifPresent(RobotRecord::placed);
    }

    /// Time since the run's start.
    Duration elapsed() {
        return clock.elapsed();
    }

    /// Since the start of the run [s].
    public double time() {
        return elapsed().toNanos() / 1e9; // not * 1e-9, which makes 147.6 s 147.60000000000002
    }

    @Override
    public double value(Quantity quantity) {
        return Objects.requireNonNull(values.get(quantity.type().word())).applyAsDouble(quantity.names());
    }

    @Override
    public boolean holdsForAll(Quantity quantity) {
        String name = quantity.names().getFirst();
        int all = quantity.type().names().contains(NameKind.ROLE) ? robots(name) : things(name);
        NamedMetric metric = offered.get(quantity.type().word());
        if (metric != null) {
            return metric.holdsForAll(quantity.type().word(), name, all);
        }
        if (quantity.type().equals(RunQuantities.ARRIVED)) { // of robots that are gone nobody expects it
            int there = all - among(gone, name);
            return there > 0 && value(quantity) >= there;
        }
        return value(quantity) >= all;
    }

    private int robots(String role) {
        return (int) records.values().stream()
                .filter(own -> own.hasRole(Optional.of(role)))
                .count();
    }

    private int things(String group) {
        return plan.things().stream()
                .filter(things -> things.name().equals(group))
                .mapToInt(things -> things.each().size())
                .sum();
    }

    private int exploring(String role) {
        Set<String> busy = exploring.entrySet().stream()
                .filter(entry -> entry.getValue() && !gone.contains(entry.getKey()))
                .map(Map.Entry::getKey)
                .collect(Collectors.toSet());
        return among(busy, role);
    }

    private int among(Set<String> robots, String role) {
        return (int) records.entrySet().stream()
                .filter(entry -> robots.contains(entry.getKey()))
                .filter(entry -> entry.getValue().role().equals(role))
                .count();
    }

    /// What was measured so far, in the scenario's order.
    public List<Finding> findings() {
        return new MetricFindings(this, records, quantities, ofRun, published, firstTimes, time()).of(plan.metrics());
    }

    /// @param value empty when there was nothing to measure
    public record Finding(String name, OptionalDouble value, boolean inBounds) {}
}
