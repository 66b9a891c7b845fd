package rsal.engine;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.agent.message.Caught;
import rsal.agent.message.FormationSlots;
import rsal.agent.message.GoalReached;
import rsal.agent.message.NewGoal;
import rsal.agent.message.VictimFound;
import rsal.agent.message.Visited;
import rsal.agent.message.Watch;
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
import rsal.robot.Robot;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.Measured;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.condition.Facts;
import rsal.scenario.condition.Measure;
import rsal.scenario.condition.Measure.Aggregate;
import rsal.scenario.condition.Quantity;

/// Looks at a run after each step: is it over, and what is there to measure? It alone compares robots with the
/// truth. All calls on the run's thread.
final class MetricsObserver implements Facts {
    private final RunPlan plan;
    private final EventLog eventLog;
    private final InstantSource clock;
    private final Instant start;
    private final Map<String, RobotRecord> records = new LinkedHashMap<>();
    private final CaptureMetrics captures;
    private final Map<Measured, OptionalDouble> firstTimes = new HashMap<>();
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
    private final DepotMetrics depots;
    private final ReachedMetrics reached;
    private final PatrolMetrics watched = new PatrolMetrics();
    private final FormationMetrics formationMetrics = new FormationMetrics();
    private final MappingMetrics mapped;
    private final boolean asksForShare;
    private final Map<String, Stamped<OccupancyGrid>> maps = new LinkedHashMap<>(); // of the world, by robot
    private final Map<String, Boolean> exploring = new LinkedHashMap<>(); // by robot that draws a map
    private final Set<String> started = new LinkedHashSet<>(); // of these

    MetricsObserver(RunPlan plan, EventLog eventLog, InstantSource clock) {
        this.plan = plan;
        this.eventLog = eventLog;
        this.clock = clock;
        this.start = clock.instant();
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
        this.captures = new CaptureMetrics(walls, eventLog);
        this.reached = new ReachedMetrics(plan.things(), walls, eventLog);
        this.mapped = new MappingMetrics(plan.map(), radius(plan));
        List<Quantity> asked = Stream.concat(
                        plan.stops().stream().flatMap(stop -> stop.when().quantities()),
                        plan.measures().stream()
                                .flatMap(measured -> measured.from().quantities()))
                .toList();
        this.asksForShare = asked.stream().anyMatch(quantity -> quantity.kind() == Quantity.Kind.EXPLORED);
        this.asksForPositions = asked.stream().map(Quantity::kind).anyMatch(Quantity.Kind.OF_POSITIONS::contains);
        this.positions = new PositionMetrics(plan.places());
        this.said = new MessageCounts(names(asked, Quantity.Kind.MESSAGES));
        this.heard = new MessageCounts(names(asked, Quantity.Kind.HEARD_MESSAGES));
        this.lost = new MessageCounts(names(asked, Quantity.Kind.LOST_MESSAGES));
        this.published = new Published(names(asked, Quantity.Kind.METRIC));
        for (Measured measured : plan.measures()) {
            if (measured.from() instanceof Measure.OfQuantity(var _, var quantity)
                    && quantity.kind() != Quantity.Kind.METRIC) {
                quantities.put(quantity, new Samples());
            }
        }
    }

    /// Those by which one kind of quantity is asked for.
    private static List<String> names(List<Quantity> asked, Quantity.Kind kind) {
        return asked.stream()
                .filter(quantity -> quantity.kind() == kind)
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
    Optional<String> look(Optional<SimulationControl> simulation, RobotPoses where, Map<String, Robot> robots) {
        simulation.ifPresent(truth -> noteContacts(truth.contacts()));
        counting = counting || robots.keySet().stream().anyMatch(where::isSimulated);
        if (depots.areThere()) {
            simulation.ifPresent(truth -> depots.look(truth.things()));
        }
        List<ReachedMetrics.There> there =
                reached.isWanted() || asksForPositions || captures.isWaiting() ? there(where) : List.of();
        if (reached.isWanted()) {
            simulation.ifPresent(truth -> reached.look(truth.things(), there, time()));
        }
        if (asksForPositions) {
            positions.look(there);
        }
        if (captures.isWaiting()) {
            captures.look(there).forEach(this::noteCapture);
        }
        records.forEach((id, own) -> {
            where.truth(id).ifPresent(mapFromBase -> noteTruth(id, own, mapFromBase));
            Optional.ofNullable(robots.get(id))
                    .flatMap(robot -> robot.find(Localizer.class))
                    .flatMap(Localizer::latest)
                    .ifPresent(estimate -> noteEstimate(own, estimate));
            Optional.ofNullable(robots.get(id))
                    .flatMap(robot -> robot.find(Battery.class))
                    .flatMap(Battery::latest)
                    .ifPresent(battery -> own.charged(battery.value().level(), time()));
            Optional.ofNullable(robots.get(id))
                    .flatMap(robot -> robot.find(Mapper.class))
                    .ifPresent(mapper -> noteMap(id, mapper, where.mapFromBase(id)));
        });
        formationMetrics.look(clock.instant());
        exploring.keySet().removeIf(robot -> started.contains(robot) && !robots.containsKey(robot));
        watched.look(time());
        noteQuantities();
        noteFirstTimes();
        return ending();
    }

    private List<ReachedMetrics.There> there(RobotPoses where) {
        var there = new ArrayList<ReachedMetrics.There>();
        records.forEach((id, own) -> where.mapFromBase(id)
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

    private void noteTruth(String robot, RobotRecord own, Pose2d mapFromBase) {
        eventLog.hash(mapFromBase);
        own.moved(clock.instant(), mapFromBase);
        if (!gone.contains(robot)) {
            formationMetrics
                    .mapFromSlot(robot, clock.instant())
                    .ifPresent(mapFromSlot -> own.outOfPlace(mapFromSlot.distanceTo(mapFromBase), time()));
        }
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
            mapper.latest().filter(map -> map.frame().equals(RobotRecord.WORLD)).ifPresent(map -> maps.put(robot, map));
        }
    }

    private void noteQuantities() {
        quantities.forEach((quantity, samples) -> {
            double value = quantity.of(this);
            if (!Double.isNaN(value)) {
                samples.add(time(), value);
            }
        });
    }

    private void noteFirstTimes() {
        for (Measured measured : plan.measures()) {
            if (measured.from() instanceof Measure.FirstTime(var condition)
                    && !firstTimes.containsKey(measured)
                    && condition.holds(this)) {
                firstTimes.put(measured, OptionalDouble.of(time()));
            }
        }
    }

    /// A prey says that it has been caught. Counts from when that is so.
    void heard(Caught said, RobotPoses where) {
        if (!records.containsKey(said.prey())) {
            return;
        }
        String role = Optional.ofNullable(records.get(said.hunter()))
                .map(RobotRecord::role)
                .orElse("");
        if (captures.heard(said, role, where.mapFromBase(said.prey()), where.mapFromBase(said.hunter()))) {
            noteCapture(said.prey());
        }
    }

    private void noteCapture(String prey) {
        captures.distance(prey)
                .ifPresent(distance ->
                        Optional.ofNullable(records.get(prey)).ifPresent(own -> own.caught(distance, time())));
    }

    /// An agent publishes a value under a name.
    void published(String agent, Optional<String> robot, String name, double value) {
        published.add(agent, robot, name, value, time());
    }

    /// A team watches places.
    void heard(Watch said) {
        watched.watch(said.mapFromPlaces(), time());
    }

    /// A robot has been where its team watches. Counts when that is so.
    void heard(Visited said, RobotPoses where) {
        where.mapFromBase(said.robot())
                .ifPresent(mapFromBase -> watched.visit(said.mapFromPlace(), mapFromBase, time()));
    }

    /// Somebody tells of a victim.
    void heard(VictimFound said) {
        reached.heard(said);
    }

    /// Robots are sent somewhere.
    void heard(NewGoal order) {
        if (order.robot().equals(NewGoal.ALL)) {
            sentTo.replaceAll((_, _) -> order.mapFromGoal());
            arrived.clear();
        }
        sentTo.put(order.robot(), order.mapFromGoal());
        arrived.remove(order.robot());
    }

    /// A drive has ended.
    void heard(GoalReached end) {
        boolean newest = end.mapFromGoal().equals(sentTo.getOrDefault(end.robot(), sentTo.get(NewGoal.ALL)));
        if (newest && end.reached()) {
            arrived.add(end.robot());
        }
    }

    /// Somebody tells robots of a formation where they should be.
    void heard(String leader, FormationSlots ranks) {
        formationMetrics.heard(leader, ranks, clock.instant());
    }

    /// A robot has come. Robots that leave count on, as they were last.
    void joined(String robot, String role) {
        records.computeIfAbsent(robot, _ -> new RobotRecord(role)).placed();
    }

    void faultBegan() {
        faults++;
    }

    void messageSaid(String topic) {
        said.add(topic);
    }

    void messageHeard(String topic) {
        heard.add(topic);
    }

    void messageLost(String topic) {
        lost.add(topic);
    }

    /// Robots that are gone now.
    void gone(Set<String> robots) {
        gone = robots;
    }

    /// A robot is going to be put elsewhere.
    void placed(String robot) {
        Optional.ofNullable(records.get(robot)).ifPresent(RobotRecord::placed);
    }

    /// Time since the run's start.
    Duration elapsed() {
        return Duration.between(start, clock.instant());
    }

    @Override
    public double time() {
        return elapsed().toNanos() / 1e9; // not * 1e-9, which makes 147.6 s 147.60000000000002
    }

    @Override
    public double collisions() {
        return counting ? contacts : Double.NaN;
    }

    @Override
    public double wallCollisions() {
        return counting ? wallCollisions : Double.NaN;
    }

    @Override
    public int robots(String role) {
        return (int) records.values().stream().filter(of(Optional.of(role))).count();
    }

    @Override
    public int caught(String role) {
        return among(captures.caught(), role);
    }

    @Override
    public int arrived(String role) {
        return among(arrived, role);
    }

    @Override
    public int gone(String role) {
        return among(gone, role);
    }

    @Override
    public long faults() {
        return faults;
    }

    @Override
    public long messages() {
        return said.all();
    }

    @Override
    public long heardMessages() {
        return heard.all();
    }

    @Override
    public long lostMessages() {
        return lost.all();
    }

    @Override
    public long messages(String topic) {
        return said.of(topic);
    }

    @Override
    public long heardMessages(String topic) {
        return heard.of(topic);
    }

    @Override
    public long lostMessages(String topic) {
        return lost.of(topic);
    }

    @Override
    public double distance(String role, String other) {
        return positions.distance(role, other);
    }

    @Override
    public int within(String role, String place) {
        return positions.within(role, place);
    }

    @Override
    public int visits(String role, String place) {
        return positions.visits(role, place);
    }

    @Override
    public double metric(String name) {
        return published.newest(name);
    }

    @Override
    public double explored() {
        return mapped.share(maps.values());
    }

    @Override
    public int things(String group) {
        return plan.things().stream()
                .filter(things -> things.name().equals(group))
                .mapToInt(things -> things.each().size())
                .sum();
    }

    @Override
    public int collected(String group) {
        return depots.collected(group);
    }

    @Override
    public int found(String group) {
        return reached.found(group);
    }

    @Override
    public int reached(String group) {
        return reached.reached(group);
    }

    @Override
    public int exploring(String role) {
        Set<String> busy = exploring.entrySet().stream()
                .filter(entry -> entry.getValue() && !gone.contains(entry.getKey()))
                .map(Map.Entry::getKey)
                .collect(Collectors.toSet());
        return among(busy, role);
    }

    @Override
    public double forming() {
        return formationMetrics.forming().toNanos() / 1e9;
    }

    private int among(Set<String> robots, String role) {
        return (int) records.entrySet().stream()
                .filter(entry -> robots.contains(entry.getKey()))
                .filter(entry -> entry.getValue().role().equals(role))
                .count();
    }

    /// What was measured so far, in the scenario's order.
    List<Finding> findings() {
        var findings = new ArrayList<Finding>();
        for (Measured measured : plan.measures()) {
            if (measured.perRobot()) {
                records.forEach((id, own) -> {
                    if (of(measured.from().role()).test(own)) {
                        findings.add(finding(measured, measured.nameOf(id), List.of(own), Optional.of(id)));
                    }
                });
            } else {
                var all = records.values().stream()
                        .filter(of(measured.from().role()))
                        .toList();
                findings.add(finding(measured, measured.name(), all, Optional.empty()));
            }
        }
        return findings;
    }

    /// @param robot whose it is; empty for all
    private Finding finding(Measured measured, String name, List<RobotRecord> from, Optional<String> robot) {
        OptionalDouble value = switch (measured.from()) {
            case Measure.FirstTime _ -> firstTimes.getOrDefault(measured, OptionalDouble.empty());
            case Measure.Count(var quantity) -> known(quantity.of(this));
            case Measure.Distance _ ->
                from.stream().anyMatch(RobotRecord::seen)
                        ? OptionalDouble.of(
                                from.stream().mapToDouble(RobotRecord::distance).sum())
                        : OptionalDouble.empty();
            case Measure.OfSignal(var aggregate, var signal, var _) ->
                signal.isOfRobots()
                        ? value(
                                aggregate,
                                from.stream().map(own -> own.samples(signal)).toList())
                        : watched.idleTimes().value(aggregate, time());
            case Measure.OfQuantity(var aggregate, var quantity) ->
                quantity.kind() == Quantity.Kind.METRIC
                        ? value(aggregate, published.samples(quantity.names().getFirst(), robot))
                        : quantities.getOrDefault(quantity, new Samples()).value(aggregate, time());
        };
        boolean inBounds =
                value.isEmpty() || (value.getAsDouble() >= measured.min() && value.getAsDouble() <= measured.max());
        return new Finding(name, value, inBounds);
    }

    private OptionalDouble value(Aggregate aggregate, List<Samples> several) {
        return Samples.together(several, time()).value(aggregate, time());
    }

    private static OptionalDouble known(double value) {
        return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    private static Predicate<RobotRecord> of(Optional<String> role) {
        return own -> role.isEmpty() || role.get().equals(own.role());
    }

    /// @param value empty when there was nothing to measure
    record Finding(String name, OptionalDouble value, boolean inBounds) {}
}
