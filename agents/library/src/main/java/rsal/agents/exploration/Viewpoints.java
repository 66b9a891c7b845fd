package rsal.agents.exploration;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.parts.AgentWords;
import rsal.behavior.LimitTurnRate;
import rsal.behavior.Pilot;
import rsal.behavior.Subsumption;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.settings.Parameter;

/// Has a robot go to places that are spread over the map and look all around at each, the nearest first by the way
/// there, until it or others have been at all of them; then at others. Goes to none where another is about to look.
public final class Viewpoints {
    public static final Parameter<Integer> COUNT = Parameter.integer(
            "viewpoints",
            12,
            1,
            1000,
            "",
            "Number of places at which it looks around, when it drives between viewpoints.");

    private static final double CLEARANCE = 0.45; // m
    private static final int MORE = 3; // places
    private static final Duration AGAIN = Duration.ofSeconds(1);
    private static final Tolerance THERE = Tolerance.position(0.4);
    private static final double SAME = 1.5; // m; places nearer to each other are seen from each other
    private static final double TURN = Math.toRadians(45); // per s
    private static final double MOST_TURN = 1.0; // rad/s
    private static final Duration HELD = Duration.ofSeconds(1); // after which it turns the other way
    private static final double ALL_AROUND = Math.toRadians(330); // the camera sees the rest
    private static final double NONE = 1e-3; // rad; not worth a turn

    private final AgentContext self;
    private final Robot robot;
    private final Supplier<Optional<Pose2d>> belief;
    private final int count;
    private final DoubleSupplier fieldOfView;
    private final NavigationClient driver;
    private final Pilot pilot;
    private final PlaceFinder finder;
    private final PlannedPaths plannedPaths;
    private final List<Point2d> left = new ArrayList<>(); // to be looked from in this round
    private final Map<String, Point2d> others = new HashMap<>(); // where they are about to look, by robot
    private List<Point2d> places = List.of(); // of this round
    private int rounds;
    private boolean paused;
    private int pauses; // what was begun before one counts no more
    private int search; // for places; only the newest counts
    private Subscription turning = () -> {};

    /// @param driver the robot's, which those that pause this may have
    /// @param belief where the robot is in the map
    /// @param count how many places, at first
    /// @param fieldOfView of what it looks with [rad]: who sees all around need not turn
    public Viewpoints(
            AgentContext self,
            Robot robot,
            NavigationClient driver,
            Supplier<Optional<Pose2d>> belief,
            int count,
            DoubleSupplier fieldOfView) {
        this.self = self;
        this.robot = robot;
        this.belief = belief;
        this.count = count;
        this.fieldOfView = fieldOfView;
        this.driver = driver;
        this.pilot = robot.require(Pilot.class);
        this.finder = robot.require(PlaceFinder.class);
        this.plannedPaths = new PlannedPaths(robot.find(Planner.class));
        self.atEnd(pilot::release);
    }

    public void begin() {
        self.subscribe(Lookout.TOPIC, message -> note(message.content()));
        self.state("choosing lookouts");
        findSoon();
    }

    private void findSoon() {
        int now = ++search;
        self.scheduler().after(AGAIN, () -> {
            if (now == search) {
                findPlaces();
            }
        });
    }

    /// In each round a few more than before, and so others: what none of them shows, some may show in the next.
    private void findPlaces() {
        Optional<Pose2d> mapFromBase = belief.get();
        if (mapFromBase.isEmpty()) {
            findSoon();
            return;
        }
        int now = ++search;
        finder.find(mapFromBase.get(), count + rounds * MORE, CLEARANCE)
                .whenComplete((result, error) -> self.scheduler().execute(() -> {
                    if (now != search) {
                        return; // it looks again when it goes on
                    }
                    switch (result) {
                        case PlaceFinder.Result.Found(List<Point2d> found) -> {
                            rounds++;
                            places = found;
                            left.addAll(found);
                            next();
                        }
                        case PlaceFinder.Result.None(String why) -> noPlaces(why);
                        case null -> throw new IllegalStateException("Looking for lookouts failed.", error);
                    }
                }));
    }

    /// There is no room for more: it begins with the first again.
    private void noPlaces(String why) {
        self.state("has no lookouts: " + why);
        rounds = 0;
        left.addAll(places);
        if (!left.isEmpty()) {
            next();
        }
    }

    private void note(Lookout other) {
        if (other.done()) {
            others.remove(other.robot());
            left.removeIf(place -> place.distanceTo(other.mapFromPlace()) < SAME);
        } else {
            others.put(other.robot(), other.mapFromPlace());
        }
    }

    /// Lets others drive the robot, until it is to go on.
    public void pause() {
        paused = true;
        pauses++;
        search++;
        letGo();
    }

    /// Drives the robot again.
    public void goOn() {
        if (paused) {
            paused = false;
            next();
        }
    }

    private void letGo() {
        turning.cancel();
        pilot.release();
    }

    private void next() {
        Optional<Pose2d> mapFromBase = belief.get();
        if (paused) {
            return;
        }
        if (left.isEmpty() || mapFromBase.isEmpty()) {
            findPlaces();
            return;
        }
        List<Point2d> free = left.stream()
                .filter(place -> others.values().stream().noneMatch(other -> other.distanceTo(place) < SAME))
                .toList();
        chooseOf(free.isEmpty() ? List.copyOf(left) : free, mapFromBase.get());
    }

    private void chooseOf(List<Point2d> candidates, Pose2d mapFromBase) {
        int now = pauses;
        plannedPaths
                .costs(mapFromBase, AgentWords.poses(candidates))
                .thenAccept(costs -> self.scheduler().execute(() -> {
                    if (now == pauses) {
                        go(candidates.get(costs.indexOf(Collections.min(costs))));
                    }
                }));
    }

    private void go(Point2d place) {
        int now = pauses;
        left.remove(place);
        self.publish(Lookout.TOPIC, new Lookout(robot.id(), place, false));
        self.state("going to look around at " + AgentWords.place(AgentWords.pose(place)));
        driver.goTo(AgentWords.pose(place), THERE, result -> {
            if (now != pauses) {
                return;
            }
            if (result instanceof Navigator.Result.Reached && turn() > NONE) {
                lookAround(place);
            } else {
                done(place);
            }
        });
    }

    /// How far it has to turn to see all around [rad].
    private double turn() {
        return Math.min(ALL_AROUND, 2 * Math.PI - fieldOfView.getAsDouble());
    }

    private void lookAround(Point2d place) {
        self.state("looking around");
        var looking = new LookAround(TURN, turn(), HELD);
        pilot.engage(new Subsumption()
                .layer("turn", looking)
                .layer("limit-turn-rate", new LimitTurnRate(robot.model().footprint(), MOST_TURN)));
        turning = self.subscribe(pilot, _ -> {
            if (looking.isDone()) {
                letGo();
                done(place);
            }
        });
    }

    private void done(Point2d place) {
        self.publish(Lookout.TOPIC, new Lookout(robot.id(), place, true));
        next();
    }
}
