package rsal.agents.foraging;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.bdi.Belief;
import rsal.agent.bdi.Mind;
import rsal.agent.bdi.PlanContext;
import rsal.agents.charging.Charging;
import rsal.agents.charging.Recharging;
import rsal.agents.driving.NavigationClient;
import rsal.agents.exploration.Viewpoints;
import rsal.agents.parts.PoseReporter;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// What one forager wants: to look for things, more to bring what it knows of to its depot, more than that a
/// full battery, and most of all to bring what it holds. Tells others only where its depot is, so that none
/// takes things out of it, and where it is about to look ([Viewpoints]).
final class Forager {
    private static final Duration THINK = Duration.ofSeconds(1);
    private static final Duration REPEAT = Duration.ofSeconds(4);
    private static final Duration BARRED = Duration.ofSeconds(60); // for a thing that it could not fetch
    private static final double IN_FRONT = 0.8; // m, of what it fetches or holds
    private static final double HOLD = 20; // priorities
    private static final double CHARGE = 10;
    private static final double BRING = 5;
    private static final double LOOK = 1;

    private final AgentContext self;
    private final Robot robot;
    private final PoseReporter reporter;
    private final NavigationClient driver;
    private final Spotting spotting;
    private final Viewpoints lookouts;
    private final Charging charging;
    private final Mind mind;
    private final Belief<String> known;
    private final List<Point2d> given;
    private final double depotRadius;
    private final Depots depots;
    private final List<CollectGoal> finds = new ArrayList<>();
    private final List<Barred> barred = new ArrayList<>();
    private @Nullable FetchTask task;
    private boolean dropped; // for something more urgent

    /// What it could not fetch.
    ///
    /// @param until when it does not look at it
    private record Barred(CollectGoal thing, Instant until) {}

    Forager(AgentContext self, Robot robot, Arguments arguments) {
        this.self = self;
        this.robot = robot;
        this.reporter = new PoseReporter(self, robot, arguments, _ -> {});
        this.driver = new NavigationClient(self, robot.require(Navigator.class));
        this.spotting = new Spotting(
                self,
                robot,
                reporter,
                Spotting.color(arguments, Explore.COLOR),
                arguments.get(Explore.RANGE),
                this::see);
        this.lookouts =
                new Viewpoints(self, robot, driver, reporter::mapFromBase, arguments.get(Viewpoints.COUNT), () -> 0);
        this.charging = Recharging.charging(self, robot, driver, reporter::mapFromBase, arguments);
        this.given = arguments.get(Collecting.DEPOT);
        this.depotRadius = arguments.get(Collecting.DEPOT_RADIUS);
        this.depots = new Depots(self);
        this.mind = new Mind(self);
        this.known = mind.belief("things", "none");
    }

    void begin() {
        depots.listen();
        reporter.begin();
        spotting.begin();
        lookouts.pause(); // until it is wanted
        lookouts.begin();
        charging.goal(mind).priority(() -> CHARGE);
        mind.goal("bring things")
                .priority(() -> task == null || task.canBeDropped() ? BRING : HOLD)
                .when(() -> task != null || nearest().isPresent())
                .pause(Duration.ZERO)
                .plan("fetch the nearest", this::fetch);
        mind.goal("find things").priority(() -> LOOK).plan("look around", this::lookAround);
        self.scheduler().after(Collecting.SETTLING, this::settle);
    }

    /// Its depot is where it stands, unless it was told.
    private void settle() {
        Optional<Pose2d> here = reporter.mapFromBase();
        if (here.isEmpty()) {
            self.scheduler().after(Collecting.SETTLING, this::settle);
            return;
        }
        List<Point2d> mapFromDepots = given.isEmpty() ? List.of(here.get().position()) : given;
        depots.settle(Depots.numbered(robot.id(), mapFromDepots.size()), mapFromDepots, depotRadius);
        depots.publish();
        self.scheduler().every(REPEAT, depots::publish);
        mind.begin(THINK);
    }

    private void see(CollectGoal thing) {
        Instant now = self.scheduler().instant();
        barred.removeIf(bar -> now.isAfter(bar.until));
        Point2d there = thing.mapFromThing();
        boolean isNone = finds.stream().anyMatch(thing::isSame)
                || barred.stream().anyMatch(bar -> bar.thing.isSame(thing))
                || depots.hold(there);
        boolean inHand = task != null && distance(there) < IN_FRONT;
        if (!isNone && !inHand) {
            finds.add(thing);
            publish();
        }
    }

    /// From the robot [m]; +∞ while it does not know where it is.
    private double distance(Point2d mapFromPlace) {
        return reporter.mapFromBase()
                .map(here -> here.position().distanceTo(mapFromPlace))
                .orElse(Double.POSITIVE_INFINITY);
    }

    private void publish() {
        known.set(finds.isEmpty() ? "none" : "%d to fetch".formatted(finds.size()));
    }

    private Optional<CollectGoal> nearest() {
        return finds.stream().min(Comparator.comparingDouble(thing -> distance(thing.mapFromThing())));
    }

    private void fetch(PlanContext doing) {
        CollectGoal thing = nearest().orElseThrow(); // else it is not wanted
        Point2d mapFromDepot = depots.nearest(thing.mapFromThing()); // it settles before it thinks
        dropped = false;
        var begun = new FetchTask(
                self,
                robot,
                reporter,
                driver,
                thing,
                mapFromDepot,
                why -> self.scheduler().execute(() -> ended(doing, thing, mapFromDepot, why)));
        task = begun;
        doing.onSuspend(() -> drop(begun));
        begun.begin();
    }

    /// It goes for it again later.
    private void drop(FetchTask begun) {
        dropped = begun.canBeDropped();
        begun.drop();
    }

    private void ended(PlanContext doing, CollectGoal thing, Point2d mapFromDepot, Optional<String> why) {
        task = null;
        if (dropped) {
            doing.fail("There was something more urgent.");
            return;
        }
        finds.remove(thing);
        publish();
        if (why.isEmpty()) {
            self.publish(Collected.TOPIC, new Collected(robot.id(), thing, mapFromDepot));
            doing.succeed();
        } else {
            barred.add(new Barred(thing, self.scheduler().instant().plus(BARRED)));
            doing.fail(why.get());
        }
    }

    private void lookAround(PlanContext doing) {
        doing.onSuspend(lookouts::pause).onResume(lookouts::goOn).onEnd(lookouts::pause);
        lookouts.goOn();
    }
}
