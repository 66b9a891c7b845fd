package rsal.agents.pursuit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import rsal.agent.AgentContext;
import rsal.agent.bdi.Belief;
import rsal.agent.bdi.Goal;
import rsal.agent.bdi.Mind;
import rsal.agent.bdi.PlanContext;
import rsal.agent.message.PoseReport;
import rsal.agents.charging.Charging;
import rsal.agents.charging.Recharging;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.AgentWords;
import rsal.agents.parts.PoseReporter;
import rsal.behavior.Pilot;
import rsal.behavior.PioneerStack;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// One clever prey's part of a hunt: wants to explore, to have a full battery, and most of all not to be caught. It
/// sees hunters that are near and tells the other prey, as they tell it; and runs where hunters come last
/// ([Evasion]). One that knows hunters by their markers tells nobody where it is itself.
final class Evader {
    private static final Duration MEMORY = Duration.ofSeconds(5); // of a hunter that nobody sees any more
    private static final Duration THINK = Duration.ofSeconds(1);
    private static final Duration NEW_CHOICE = Duration.ofSeconds(1); // of where to run to
    private static final double RELIEF = 1.3; // times as far as where it began to run, hunters worry it no more
    private static final double SAME = 0.5; // m
    private static final double LOW = 0.25; // share of its battery
    private static final double FULL = 0.9;

    private final AgentContext self;
    private final Robot robot;
    private final Pilot pilot;
    private final NavigationClient driver;
    private final PoseReporter reporter;
    private final CaptureDetector surrender;
    private final Evasion evasion;
    private final Optional<MarkerSight> eyes; // else it knows what they report
    private final double sight;
    private final double fear;
    private final boolean wanders;
    private final Charging charging;
    private final Mind mind;
    private final List<Goal> goals = new ArrayList<>();
    private final Belief<Double> nearest; // hunter [m]
    private boolean running;
    private boolean choosing; // the planner has not answered yet
    private Optional<Pose2d> mapFromAim = Optional.empty(); // where it runs to

    Evader(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.robot = robot;
        this.pilot = robot.require(Pilot.class);
        this.driver = new NavigationClient(self, robot.require(Navigator.class));
        String hunter = arguments.get(Escape.HUNTER);
        boolean byMarkers = MarkerSight.byMarkers(arguments);
        this.reporter = new PoseReporter(self, robot, arguments, _ -> look(), !byMarkers);
        this.eyes = byMarkers
                ? Optional.of(new MarkerSight(self, robot, reporter::mapFromBase, hunter, this::see))
                : Optional.empty();
        this.evasion = new Evasion(self, robot);
        this.sight = arguments.get(Evade.SENSING_RANGE);
        this.wanders = Escape.wanders(arguments);
        this.fear = arguments.get(Evade.FLEE_DISTANCE);
        this.charging =
                new Charging(self, robot, driver, reporter::mapFromBase, arguments.get(Recharging.CHARGERS), LOW, FULL);
        this.mind = new Mind(self);
        this.nearest = mind.belief("nearest hunter", Double.POSITIVE_INFINITY);
        this.surrender = CaptureDetector.of(self, robot, arguments, this::letGo);
        this.self.atEnd(pilot::release);
    }

    void begin() {
        eyes.ifPresentOrElse(
                MarkerSight::begin, () -> self.subscribe(PoseReport.TOPIC, message -> hear(message.content())));
        self.subscribe(Sighting.TOPIC, message -> hear(message.content()));
        reporter.begin();
        goals.add(mind.goal("not be caught")
                .priority(() -> 10)
                .when(() -> nearest.get() < (running ? RELIEF * fear : fear))
                .plan("run", this::run));
        goals.add(charging.goal(mind).priority(() -> 5));
        goals.add(mind.goal("explore").priority(() -> 1).plan(wanders ? "wander" : "follow the wall", this::explore));
        mind.begin(THINK);
    }

    /// Wants nothing any more.
    private void letGo() {
        goals.forEach(Goal::drop);
    }

    private void hear(PoseReport report) {
        surrender.note(report, reporter.mapFromBase());
        if (surrender.isHunter(report) && isInSight(report.mapFromBase())) {
            var sighting = new Sighting(report.robot(), report.role(), report.mapFromBase());
            self.publish(Sighting.TOPIC, sighting);
            note(sighting);
        }
    }

    /// What other prey say, or hunters of what they hunt.
    private void hear(Sighting sighting) {
        if (surrender.isHunter(sighting.report())) {
            note(sighting);
        }
    }

    private void see(Sighting sighting) {
        surrender.note(sighting.report(), reporter.mapFromBase());
        if (isInSight(sighting.mapFromBase())) {
            note(sighting);
        }
    }

    private boolean isInSight(Pose2d mapFromHunter) {
        return reporter.mapFromBase()
                .filter(here -> here.distanceTo(mapFromHunter) < sight)
                .isPresent();
    }

    private void note(Sighting sighting) {
        self.blackboard().write(Sighting.TOPIC, sighting.robot(), sighting, MEMORY);
        look();
    }

    private SortedMap<String, Pose2d> hunters() {
        var poses = new TreeMap<String, Pose2d>();
        self.blackboard()
                .read(Sighting.TOPIC)
                .forEach(
                        note -> poses.put(note.content().robot(), note.content().mapFromBase()));
        return poses;
    }

    private void look() {
        reporter.mapFromBase().ifPresent(here -> {
            evasion.learn(here);
            surrender.lookAround(Optional.of(here));
            double distance = hunters().values().stream()
                    .mapToDouble(here::distanceTo)
                    .min()
                    .orElse(Double.POSITIVE_INFINITY);
            nearest.set(tenths(distance));
        });
    }

    /// Rounded, for people, and so that it does not think again for every bit of it.
    private static double tenths(double value) {
        return Double.isInfinite(value) ? value : Math.round(value * 10) / 10.0;
    }

    private void explore(PlanContext doing) {
        roam();
        doing.onSuspend(pilot::release).onResume(this::roam).onEnd(pilot::release);
    }

    private void roam() {
        pilot.engage(wanders ? PioneerStack.wander(robot.model()) : PioneerStack.followLeftWall(robot.model()));
    }

    private void run(PlanContext doing) {
        running = true;
        var choices = self.scheduler().every(NEW_CHOICE, this::choose);
        doing.onEnd(() -> {
            running = false;
            mapFromAim = Optional.empty();
            choices.cancel();
            driver.stop();
            pilot.release();
        });
        choose();
    }

    /// Runs to where hunters come last, or stays where that is best. Follows the wall as long as it knows no path.
    private void choose() {
        Optional<Pose2d> here = reporter.mapFromBase();
        if (here.isEmpty() || !running || choosing) {
            return;
        }
        choosing = true;
        evasion.flee(here.get(), hunters().values(), mapFromAim, path -> {
            choosing = false;
            if (running) {
                path.ifPresentOrElse(this::take, () -> pilot.engage(PioneerStack.followLeftWall(robot.model())));
            }
        });
    }

    private void take(Path2d path) {
        if (path.points().size() > 1) {
            run(path);
        } else {
            mapFromAim = Optional.empty();
            driver.stop();
            pilot.release();
        }
    }

    private void run(Path2d path) {
        Pose2d mapFromRefuge = AgentWords.pose(path.points().getLast());
        mapFromAim = Optional.of(mapFromRefuge);
        if (!driver.isOnItsWayTo(mapFromRefuge, SAME)) {
            pilot.release();
            driver.goTo(mapFromRefuge, Tolerance.position(SAME), _ -> {});
        }
    }
}
