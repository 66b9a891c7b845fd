package rsal.agents.pursuit;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.message.NewGoal;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.agent.team.Assignment;
import rsal.agents.driving.GoalService;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.TargetTracks;
import rsal.agents.pursuit.strategy.FloorGraph;
import rsal.agents.pursuit.strategy.PursuitOrder;
import rsal.agents.pursuit.strategy.PursuitStrategy;
import rsal.agents.pursuit.strategy.PursuitStrategyType;
import rsal.agents.pursuit.strategy.PursuitView;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.robot.LineOfSight;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.PluginChoice;

/// One hunter's part of a hunt. What it knows of the others are the poses they report, and the goals that they send if
/// their strategies do.
///
/// Hunters that divide the prey among them by distance do not negotiate: each works out the same [Assignment] from
/// what all have heard, and says which part of it it takes.
final class Hunt {
    private static final double NOT_WORTH_A_NEW_PLAN = 0.1; // m
    private static final double AT_A_PLACE = 0.4; // m
    private static final double CLEARANCE = 0.3; // m, of what a strategy has for the floor

    private final AgentContext self;
    private final Robot robot;
    private final PoseReporter reporter;
    private final NavigationClient driver;
    private final GoalService goals;
    private final TargetTracks sightings;
    private final PreySearch search;
    private final String preyName;
    private final double catchDistance;
    private final Tolerance tolerance;
    private final Duration updateInterval;
    private final boolean nearest;
    private final int turn;
    private final SortedSet<String> everHeardOf = new TreeSet<>(); // of its prey
    private final Set<String> caught = new HashSet<>();
    private final Map<String, String> chases = new HashMap<>();
    private final PursuitStrategy strategy;
    private final SortedMap<String, Point2d> othersGoals = new TreeMap<>(); // by hunter
    private final Instant start;
    private @Nullable String target;
    private @Nullable Pose2d mapFromSaidGoal;
    private Optional<FloorGraph> floor = Optional.empty();

    Hunt(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.robot = robot;
        this.reporter = new PoseReporter(self, robot, arguments, this::note);
        this.driver = new NavigationClient(self, robot.require(Navigator.class));
        this.search = new PreySearch(self, robot, driver, reporter::mapFromBase, arguments, this::note);
        this.goals = new GoalService(self, robot.id(), driver, search::pause, this::decide);
        this.sightings = new TargetTracks(self.blackboard());
        this.preyName = arguments.get(Follow.PREY);
        this.catchDistance = arguments.get(Follow.CATCH_DISTANCE);
        this.tolerance = Tolerance.position(catchDistance / 2);
        this.updateInterval = arguments.seconds(Follow.UPDATE_INTERVAL);
        this.nearest = arguments.get(Follow.ASSIGNMENT).equals("nearest");
        PluginChoice choice = arguments.get(Follow.STRATEGY);
        this.strategy = choice.as(PursuitStrategyType.class).create(choice.arguments());
        this.start = self.scheduler().instant();
        this.turn = self.directory().ofRole(self.role()).stream()
                .map(Directory.Entry::name)
                .toList()
                .indexOf(self.name());
    }

    void begin() {
        search.begin();
        self.subscribe(Chase.TOPIC, message -> note(message.content()));
        self.subscribe(PursuitGoal.TOPIC, message -> note(message.content()));
        self.subscribe(Caught.TOPIC, message -> giveUp(message.content().prey()));
        self.directory().onDeparture(went -> forget(went.agent().robot()));
        self.scheduler().every(updateInterval, this::decide);
        goals.begin();
        reporter.begin();
        self.publish(PoseRequest.TOPIC, new PoseRequest(NewGoal.ALL)); // some may have been there for long
        self.state("looking for prey");
    }

    private void note(PoseReport report) {
        if (!isPrey(report) && !isHunter(report)) {
            return;
        }
        if (isPrey(report)) {
            everHeardOf.add(report.robot());
        }
        boolean discovered = sightings.note(report);
        if (discovered && isPrey(report)) {
            decide();
        } else {
            stopWhenNear();
        }
    }

    private void note(Chase chase) {
        chases.put(chase.hunter(), chase.prey());
    }

    private void note(PursuitGoal goal) {
        othersGoals.put(goal.hunter(), goal.mapFromGoal().position());
    }

    private void giveUp(String prey) {
        caught.add(prey);
        decide();
    }

    private void forget(String gone) {
        sightings.forget(gone);
        chases.remove(gone);
        othersGoals.remove(gone);
    }

    /// Goes where its strategy sends it.
    private void decide() {
        if (goals.busy()) {
            return;
        }
        SortedMap<String, Pose2d> prey = sightings.of(report -> isPrey(report) && !caught.contains(report.robot()));
        Optional<String> choice = nearest ? nearestOf(prey) : inTurn(prey.keySet());
        order(prey, choice).ifPresentOrElse(this::follow, this::rest);
    }

    /// Empty also while the hunter does not know where it is, unless its strategy is as good without.
    private Optional<PursuitOrder> order(SortedMap<String, Pose2d> prey, Optional<String> choice) {
        Optional<Pose2d> here = reporter.mapFromBase();
        if (here.isEmpty()) {
            return choice.flatMap(
                    each -> Optional.ofNullable(prey.get(each)).map(pose -> PursuitOrder.hunt(each, pose, "hunting")));
        }
        SortedMap<String, Pose2d> hunters = sightings.of(this::isHunter);
        hunters.put(robot.id(), here.get());
        double time = Duration.between(start, self.scheduler().instant()).toMillis() / 1000.0;
        return strategy.decide(new PursuitView(
                time,
                robot.id(),
                here.get(),
                hunters,
                prey,
                choice,
                othersGoals,
                catchDistance,
                search.sight(),
                () -> floor(here.get()),
                self.random()));
    }

    private Optional<FloorGraph> floor(Pose2d here) {
        if (floor.isEmpty()) {
            floor = robot.find(Localizer.class)
                    .flatMap(Localizer::givenMap)
                    .flatMap(map -> FloorGraph.of(map, here.position(), CLEARANCE));
        }
        return floor;
    }

    private void follow(PursuitOrder order) {
        say(order);
        order.prey().ifPresentOrElse(prey -> pursue(prey, order), () -> searchAt(order));
    }

    private void say(PursuitOrder order) {
        if (strategy.sendsGoals() && !order.mapFromGoal().equals(mapFromSaidGoal)) {
            mapFromSaidGoal = order.mapFromGoal();
            self.publish(
                    PursuitGoal.TOPIC, new PursuitGoal(robot.id(), order.prey().orElse(""), order.mapFromGoal()));
        }
    }

    private void searchAt(PursuitOrder order) {
        search.pause();
        target = null;
        self.state(order.words());
        if (!driver.isOnItsWayTo(order.mapFromGoal(), NOT_WORTH_A_NEW_PLAN)) {
            driver.goTo(order.mapFromGoal(), Tolerance.position(AT_A_PLACE), _ -> {});
        }
    }

    private Optional<String> nearestOf(SortedMap<String, Pose2d> prey) {
        Map<String, String> preyOf = Assignment.nearest(sightings.of(this::isHunter), prey, chases);
        return Optional.ofNullable(preyOf.get(robot.id()));
    }

    /// The prey that has this hunter's number among all prey ever heard of, or the next free one after it.
    private Optional<String> inTurn(Set<String> free) {
        var fromItsNumberOn = new ArrayList<>(everHeardOf);
        Collections.rotate(fromItsNumberOn, -turn);
        return fromItsNumberOn.stream().filter(free::contains).findFirst();
    }

    private void pursue(String prey, PursuitOrder order) {
        search.pause();
        takeOn(prey);
        Pose2d mapFromPrey = sightings.of(prey).orElseThrow(); // chosen among those seen
        if (isNear(mapFromPrey)) {
            holdAtBay(prey);
            return;
        }
        self.state(order.words());
        Pose2d mapFromGoal = order.mapFromGoal();
        if (!driver.isOnItsWayTo(mapFromGoal, NOT_WORTH_A_NEW_PLAN)) {
            boolean chases = mapFromGoal.equals(mapFromPrey);
            Tolerance near = chases ? tolerance : Tolerance.position(AT_A_PLACE);
            driver.goTo(mapFromGoal, near, result -> {
                if (chases) {
                    arrived(mapFromPrey, result);
                }
            });
        }
    }

    private void takeOn(String prey) {
        if (!prey.equals(target)) {
            target = prey;
            var chase = new Chase(robot.id(), prey);
            note(chase);
            self.publish(Chase.TOPIC, chase);
            self.show("prey", prey);
        }
    }

    private void rest() {
        if (target != null || !search.roams()) {
            target = null;
            driver.stop();
        }
        search.goOn();
        if (!search.roams()) { // else that says what it does
            self.state(caught.isEmpty() ? "looking for prey" : "looking for more prey");
        }
    }

    /// Goes on at once when the prey has gone on meanwhile. Whatever else ended the drive, the next update tries
    /// again.
    private void arrived(Pose2d mapFromGoal, Result result) {
        boolean goneOn = Optional.ofNullable(target)
                .flatMap(sightings::of)
                .filter(mapFromPrey -> mapFromPrey.distanceTo(mapFromGoal) > tolerance.distance())
                .isPresent();
        if (result instanceof Result.Reached && goneOn) {
            decide();
        }
    }

    private void stopWhenNear() {
        if (target != null && !goals.busy()) {
            String prey = target;
            sightings.of(prey).filter(this::isNear).ifPresent(_ -> holdAtBay(prey));
        }
    }

    private void holdAtBay(String prey) {
        driver.stop();
        self.state("holding %s at bay".formatted(prey));
    }

    private boolean isNear(Pose2d mapFromPrey) {
        return reporter.mapFromBase()
                .filter(here -> LineOfSight.reaches(robot, here, mapFromPrey, catchDistance))
                .isPresent();
    }

    private boolean isPrey(PoseReport report) {
        boolean itself = report.robot().equals(robot.id());
        return !itself && report.isFrom(preyName);
    }

    private boolean isHunter(PoseReport report) {
        return report.role().equals(robot.role());
    }
}
