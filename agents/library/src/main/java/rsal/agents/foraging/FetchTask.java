package rsal.agents.foraging;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.AgentWords;
import rsal.agents.parts.PoseReporter;
import rsal.behavior.LimitSpeed;
import rsal.behavior.LimitTurnRate;
import rsal.behavior.Pilot;
import rsal.behavior.PioneerStack;
import rsal.behavior.SetSpeed;
import rsal.behavior.Subsumption;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.GripperState;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.BlobFinder;
import rsal.device.DriveBase;
import rsal.device.Gripper;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.time.Task;

/// Fetches one thing: drives there with its gripper closed and up, opens it when it is near, aims by its camera, grips,
/// brings the thing to the depot and lets go of it. Where it gets nowhere it drives about for a while and tries again.
/// What it says about the end is what its gripper felt, not what it was told to do.
final class FetchTask {
    private static final Tolerance STANDOFF = Tolerance.position(0.9);
    private static final Tolerance AT_DEPOT = Tolerance.position(0.3);
    private static final double NEAR = 2.0; // m, in which it opens its gripper
    private static final double TOLERATED = 1.0; // m from where the thing should be, by both robots' errors
    private static final double SAME = 0.4; // m between two looks at it
    private static final double STOP_DISTANCE = 0.1; // m
    private static final double MOST_TURN = 1.0; // rad/s
    private static final double MOST_SPEED = 0.3; // m/s
    private static final Twist2d BACK = Twist2d.drive(-0.2, 0);
    private static final Duration BACKING = Duration.ofMillis(2500);
    private static final Duration DETOUR = Duration.ofSeconds(5);
    private static final Duration LOOK = Duration.ofMillis(200);
    private static final Duration LONGEST_AIM = Duration.ofSeconds(45);
    private static final int TRIES = 4;

    private enum Stage {
        GOING,
        AIMING,
        GRIPPING,
        BRINGING,
        RELEASING,
        ENDED
    }

    private final AgentContext self;
    private final Robot robot;
    private final PoseReporter reporter;
    private final NavigationClient driver;
    private final GripperClient hand;
    private final Pilot pilot;
    private final DriveBase base;
    private final CollectGoal goal;
    private final Point2d mapFromDepot;
    private final Consumer<Optional<String>> onEnd;
    private final List<Subscription> subscriptions = new ArrayList<>();
    private final List<Task> tasks = new ArrayList<>();
    private Stage stage = Stage.GOING;
    private boolean arrived;
    private boolean opening;
    private boolean open;
    private int troubles;
    private int misses;
    private @Nullable Aim aim;
    private Instant aimingSince = Instant.MIN;

    /// @param onEnd told once, why the thing was not collected; nothing when it was
    FetchTask(
            AgentContext self,
            Robot robot,
            PoseReporter reporter,
            NavigationClient driver,
            CollectGoal goal,
            Point2d mapFromDepot,
            Consumer<Optional<String>> onEnd) {
        this.self = self;
        this.robot = robot;
        this.reporter = reporter;
        this.driver = driver;
        this.hand = new GripperClient(self, robot.require(Gripper.class));
        this.pilot = robot.require(Pilot.class);
        this.base = robot.require(DriveBase.class);
        this.goal = goal;
        this.mapFromDepot = mapFromDepot;
        this.onEnd = onEnd;
    }

    void begin() {
        subscriptions.add(self.subscribe(robot.require(BlobFinder.class), image -> look(image.value())));
        subscriptions.add(self.subscribe(robot.require(Gripper.class), state -> feel(state.value())));
        tasks.add(self.scheduler().every(LOOK, this::watch));
        hand.closeAndLift(_ -> {});
        go();
    }

    /// Whether it is on its way with the thing.
    boolean isBringing() {
        return stage == Stage.BRINGING || stage == Stage.RELEASING;
    }

    /// Whether nothing is lost when it is dropped: it is on its way to the thing, or looks for it.
    boolean canBeDropped() {
        return stage == Stage.GOING || stage == Stage.AIMING;
    }

    /// Nobody wants it any more. What it holds already it brings all the same.
    void drop() {
        if (canBeDropped()) {
            end(Optional.of("Nobody wants it any more."));
        }
    }

    private void go() {
        stage = Stage.GOING;
        arrived = false;
        self.state("driving to " + goal);
        driver.goTo(AgentWords.pose(goal.mapFromThing()), STANDOFF, result -> {
            if (stage == Stage.GOING) {
                if (result instanceof Navigator.Result.Reached) {
                    arrived = true;
                    open();
                    aimWhenReady();
                } else {
                    detour(result, this::go);
                }
            }
        });
    }

    private void watch() {
        boolean near = reporter.mapFromBase()
                .filter(here -> here.position().distanceTo(goal.mapFromThing()) < NEAR)
                .isPresent();
        if (stage == Stage.GOING && near) {
            open();
        }
        boolean tooLong = Duration.between(aimingSince, now()).compareTo(LONGEST_AIM) > 0;
        if (stage == Stage.AIMING && aim != null && (aim.inVain() || tooLong)) {
            missed(aim.seen());
        }
    }

    private void open() {
        if (!opening) {
            opening = true;
            hand.lowerAndOpen(result -> {
                open = result instanceof Gripper.Result.Reached;
                opening = open; // else once more
                aimWhenReady();
            });
        }
    }

    private void aimWhenReady() {
        if (stage == Stage.GOING && arrived && open) {
            aim();
        }
    }

    private void aim() {
        Optional<Point2d> guess = inOdometry(goal.mapFromThing());
        if (guess.isEmpty()) {
            end(Optional.of("I don't know where I am."));
            return;
        }
        stage = Stage.AIMING;
        aimingSince = now();
        self.state("aiming at " + goal);
        var aiming = new Aim(guess.get());
        aim = aiming;
        pilot.engage(new Subsumption()
                .layer("aim", aiming)
                .layer("limit-turn-rate", new LimitTurnRate(robot.model().footprint(), MOST_TURN))
                .layer("limit-speed", new LimitSpeed(robot.model().footprint(), MOST_SPEED, STOP_DISTANCE)));
    }

    /// The thing is that patch of its color which is nearest to where it should be.
    private void look(Blobs image) {
        Optional<Pose2d> odomFromBase = base.latest().map(Stamped::value).map(Odometry::odomFromBase);
        if (stage != Stage.AIMING || aim == null || odomFromBase.isEmpty()) {
            return;
        }
        Aim aiming = aim;
        double tolerated = aiming.seen() ? SAME : TOLERATED;
        image.blobs().stream()
                .filter(blob -> blob.color().equals(goal.color()))
                .flatMap((Blob blob) -> image.baseFromBlob(blob).stream())
                .map(odomFromBase.get()::transform)
                .filter(place -> place.distanceTo(aiming.odomFromTarget()) < tolerated)
                .min(Comparator.comparingDouble(aiming.odomFromTarget()::distanceTo))
                .ifPresent(aiming::spot);
    }

    private void feel(GripperState state) {
        if (stage == Stage.AIMING && state.innerBeamBroken()) {
            grip();
        }
    }

    private void grip() {
        stage = Stage.GRIPPING;
        self.state("gripping " + goal);
        pilot.release();
        open = false;
        opening = false;
        hand.closeAndLift(_ -> {
            if (stage == Stage.GRIPPING) {
                if (hand.isHolding()) {
                    troubles = 0;
                    bring();
                } else {
                    hand.lowerAndOpen(_ -> missed(true));
                }
            }
        });
    }

    /// It is not between the paddles.
    private void missed(boolean seen) {
        pilot.release();
        if (stage == Stage.ENDED) {
            return;
        }
        misses++;
        if (!seen || misses == TRIES) {
            end(Optional.of(seen ? "I can't grip it." : "There is nothing."));
            return;
        }
        stage = Stage.GRIPPING;
        backOff(this::aim);
    }

    private void bring() {
        stage = Stage.BRINGING;
        self.state("bringing %s to the depot".formatted(goal));
        driver.goTo(AgentWords.pose(mapFromDepot), AT_DEPOT, result -> {
            if (stage == Stage.BRINGING) {
                if (result instanceof Navigator.Result.Reached) {
                    release();
                } else {
                    detour(result, this::bring);
                }
            }
        });
    }

    private void release() {
        if (!hand.isHolding()) {
            end(Optional.of("I lost it on the way."));
            return;
        }
        stage = Stage.RELEASING;
        self.state("releasing " + goal);
        hand.lowerAndOpen(_ -> {
            if (stage == Stage.RELEASING) {
                if (hand.isHolding()) {
                    detour(this::bring, "there is no room for it in the depot");
                } else {
                    backOff(() -> end(Optional.empty()));
                }
            }
        });
    }

    private void detour(Navigator.Result ending, Runnable again) {
        String why = AgentWords.reason(ending);
        detour(again, why.isEmpty() ? "it was sent elsewhere" : why);
    }

    /// Drives about for a while, to be elsewhere when it tries again.
    private void detour(Runnable again, String why) {
        troubles++;
        if (troubles == TRIES) {
            giveUp("I get nowhere: " + why);
            return;
        }
        self.state("making a detour: " + why);
        pilot.engage(PioneerStack.wander(robot.model()));
        later(DETOUR, again);
    }

    /// Where it can't go on, others may: what it holds it puts down.
    private void giveUp(String why) {
        if (hand.isHolding()) {
            stage = Stage.RELEASING;
            hand.lowerAndOpen(_ -> backOff(() -> end(Optional.of(why))));
        } else {
            end(Optional.of(why));
        }
    }

    private void backOff(Runnable then) {
        pilot.engage(new Subsumption()
                .layer("back", new SetSpeed(BACK))
                .layer("limit-speed", new LimitSpeed(robot.model().footprint(), MOST_SPEED, STOP_DISTANCE)));
        later(BACKING, then);
    }

    private void later(Duration delay, Runnable then) {
        Stage now = stage;
        tasks.add(self.scheduler().after(delay, () -> {
            if (stage == now) {
                pilot.release();
                then.run();
            }
        }));
    }

    private void end(Optional<String> why) {
        if (stage == Stage.ENDED) {
            return;
        }
        stage = Stage.ENDED;
        subscriptions.forEach(Subscription::cancel);
        tasks.forEach(Task::cancel);
        pilot.release();
        driver.stop();
        onEnd.accept(why);
    }

    private Optional<Point2d> inOdometry(Point2d mapFromPlace) {
        return reporter.mapFromBase()
                .flatMap(mapFromBase -> base.latest()
                        .map(reading -> reading.value()
                                .odomFromBase()
                                .compose(mapFromBase.inverse())
                                .transform(mapFromPlace)));
    }

    private Instant now() {
        return self.scheduler().instant();
    }
}
