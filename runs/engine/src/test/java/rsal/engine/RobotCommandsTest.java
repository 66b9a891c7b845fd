package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.engine.arbitration.KeyboardDriving;
import rsal.engine.report.Answer;
import rsal.engine.report.DeviceView;
import rsal.engine.report.RobotView;
import rsal.engine.report.SentGoal;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.system.CommandTimeout;
import rsal.testkit.Trials;

/// What people tell the robots of a world to do: by keys, by a behavior, by a place to go to.
@Timeout(60)
class RobotCommandsTest {
    private static final String HALL = """
            define scanner ranger ( sensor ( range [0 5] fov 240 samples 121 ) )
            define cart position ( size [0.4 0.3 0.2] scanner ( ) )
            define drifter cart ( localization "odom" odom_error [0.02 0.02 0 0.02] )
            define glider cart ( drive "omni" )
            model ( name "walls" size [12 10 1] boundary 1 )
            model ( name "pillar" size [1 1 1] pose [0 0 0 0] )
            cart ( name "idle" pose [-4 -3 0 0] )
            cart ( name "roamer" pose [4 3 0 180] ctrl "wander" )
            drifter ( name "drifter" pose [-4 3 0 0] )
            glider ( name "glider" pose [4 -3 0 90] )
            position ( name "blind" pose [0 4 0 0] size [0.4 0.3 0.2] )
            cart ( name "car" pose [0 -4 0 0] drive "car" wheelbase 0.3 )
            """;

    @TempDir
    private Path folder;

    private final AtomicLong handClock = new AtomicLong(); // [ns]
    private LiveRun run;

    @BeforeEach
    void start() {
        try {
            Path world = Files.writeString(folder.resolve("hall.world"), HALL);
            run = LiveRun.of(Scenario.load(world.toString()).plan(RunOptions.NONE.withSpeed(1)))
                    .operatorClock(handClock::get)
                    .start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        await(s -> !s.robots().isEmpty());
        run.pause();
        await(Snapshot::paused);
    }

    @AfterEach
    void end() {
        run.close();
    }

    /// The first snapshot that is as wanted.
    private Snapshot await(Predicate<Snapshot> wanted) {
        for (int tries = 0; tries < 1000; tries++) {
            var news = new CountDownLatch(1);
            try (var _ = run.onSnapshot(news::countDown)) {
                Snapshot snapshot = run.snapshot();
                if (wanted.test(snapshot)) {
                    return snapshot;
                }
                assertThat(news.await(30, TimeUnit.SECONDS)).as("a snapshot").isTrue();
            } catch (InterruptedException e) {
                throw new AssertionError(e);
            }
        }
        throw new AssertionError("It was never as wanted: %s".formatted(run.events(0)));
    }

    private static RobotView robot(Snapshot snapshot, String id) {
        return snapshot.robots().stream()
                .filter(robot -> robot.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private static Pose2d pose(Snapshot snapshot, String id) {
        return robot(snapshot, id).truth().orElseThrow();
    }

    /// One that is made after it was asked for, within 45 ms.
    private Snapshot now() {
        return run.freshSnapshot()
                .toCompletableFuture()
                .orTimeout(30, TimeUnit.SECONDS)
                .join();
    }

    private static Answer answer(CompletionStage<Answer> stage) {
        return stage.toCompletableFuture().orTimeout(10, TimeUnit.SECONDS).join();
    }

    private static void done(CompletionStage<Answer> stage) {
        assertThat(answer(stage)).isEqualTo(new Answer.Done());
    }

    /// @return the goal
    private SentGoal sent(CompletionStage<Answer> stage) {
        int id = ((Answer.Sent) answer(stage)).goal();
        return goal(id);
    }

    private SentGoal goal(int id) {
        return run.goals().stream().filter(goal -> goal.id() == id).findFirst().orElseThrow();
    }

    private static String refusal(CompletionStage<Answer> stage) {
        return ((Answer.Refused) answer(stage)).why();
    }

    /// Keeps a key pressed for some steps of 100 ms.
    private Snapshot drive(String robot, Twist2d velocity, int steps) {
        for (int step = 0; step < steps; step++) {
            Duration after = run.elapsed().plus(run.plan().step());
            done(run.operator().drive(robot, "me", velocity));
            run.step();
            Awaitility.await("a step")
                    .atMost(Duration.ofSeconds(30))
                    .pollInSameThread()
                    .pollDelay(Duration.ZERO)
                    .pollInterval(Duration.ofMillis(1))
                    .until(() -> run.elapsed().compareTo(after) >= 0); // snapshots come less often
        }
        return now();
    }

    /// Whether a behavior drives it: of a wanderer, any of its layers.
    private static boolean roams(RobotView robot) {
        return !robot.inCharge().isEmpty() && !robot.inCharge().equals("navigator");
    }

    private void go() {
        go(Double.POSITIVE_INFINITY);
    }

    private void go(double speed) {
        run.speed(speed);
        run.resume();
    }

    private boolean happened(String robot, String text) {
        return run.events(0).stream()
                .anyMatch(e -> e.subject().equals(robot) && e.text().contains(text));
    }

    @Test
    void aHandDrivesUntilItLetsGo() {
        Pose2d start = pose(now(), "idle");
        Snapshot driven = drive("idle", Twist2d.drive(0.5, 0), 10);
        assertThat(pose(driven, "idle").x()).isGreaterThan(start.x() + 0.2);
        assertThat(robot(driven, "idle").driver()).isEqualTo("me");
        assertThat(robot(driven, "idle").inCharge()).isEmpty();
        done(run.operator().release("idle", "me"));
        assertThat(robot(now(), "idle").driver()).isEmpty();
        assertThat(happened("idle", "driven by keys")).isTrue();
        assertThat(happened("idle", "(0.50, 0.00) m/s, 0°/s")).isTrue();
        assertThat(happened("idle", "no longer driven by keys")).isTrue();
        assertThat(run.events(0))
                .filteredOn(e -> e.text().contains("m/s"))
                .as("what stays the same is told once")
                .hasSize(1);
    }

    @Test
    void anAgentHasToWaitAndGoesOnAfterwards() {
        Snapshot driven = drive("roamer", Twist2d.drive(-0.3, 0), 8);
        assertThat(pose(driven, "roamer").x())
                .as("backwards, which no wanderer does")
                .isGreaterThan(4.05);
        Pose2d held = pose(drive("roamer", Twist2d.STOP, 8), "roamer");
        assertThat(pose(drive("roamer", Twist2d.STOP, 3), "roamer")).isEqualTo(held);
        done(run.operator().release("roamer", "me"));
        go();
        await(s -> roams(robot(s, "roamer")) && pose(s, "roamer").distanceTo(held) > 0.5);
    }

    @Test
    void anOmnidirectionalRobotGoesSideways() {
        Pose2d start = pose(now(), "glider");
        Pose2d driven = pose(drive("glider", new Twist2d(0, 0.4, 0), 10), "glider");
        Pose2d motion = start.inverse().compose(driven);
        assertThat(motion.y()).isGreaterThan(0.2);
        assertThat(Math.abs(motion.x())).isLessThan(0.01);
    }

    @Test
    void noBaseIsDrivenFasterThanItCan() {
        Snapshot fast = drive("idle", Twist2d.drive(50, 0), 15);
        double limit = run.plan().robots().getFirst().spec().model().drive().maxSpeed();
        assertThat(robot(fast, "idle")
                        .odometry()
                        .orElseThrow()
                        .value()
                        .velocity()
                        .vx())
                .isCloseTo(limit, org.assertj.core.api.Assertions.within(1e-9));
    }

    @Test
    void aRobotStandsStillWhenItsDriverFallsSilentAndIsGivenBack() {
        drive("roamer", Twist2d.drive(-0.3, 0), 3);
        run.resume();
        handClock.addAndGet(CommandTimeout.USUAL.toNanos());
        await(_ -> happened("roamer", "stands still: its driver is not heard"));
        await(s ->
                robot(s, "roamer").odometry().orElseThrow().value().velocity().equals(Twist2d.STOP));
        assertThat(robot(now(), "roamer").driver()).isEqualTo("me");
        handClock.addAndGet(KeyboardDriving.LEASE.toNanos());
        await(s -> robot(s, "roamer").driver().isEmpty());
        assertThat(happened("roamer", "its driver is gone")).isTrue();
        await(s -> roams(robot(s, "roamer")));
    }

    @Test
    void onlyOneDrivesARobot() {
        done(run.operator().drive("idle", "me", Twist2d.STOP));
        assertThat(refusal(run.operator().drive("idle", "you", Twist2d.drive(0.2, 0))))
                .isEqualTo("Somebody else drives robot 'idle' by keys.");
        done(run.operator().release("idle", "you"));
        assertThat(robot(now(), "idle").driver()).isEqualTo("me");
        assertThat(refusal(run.operator().goTo("idle", new Pose2d(3, 0, 0)))).contains("'idle' is driven by keys");
        assertThat(refusal(run.operator().behave("idle", "wander"))).contains("'idle' is driven by keys");
        done(run.operator().release("idle", "me"));
        done(run.operator().drive("idle", "you", Twist2d.STOP));
    }

    @Test
    void whoIsHeardNoLongerKeepsNobodyOut() {
        for (int time = 0; time < 20; time++) {
            done(run.operator().drive("idle", "me", Twist2d.STOP));
            handClock.addAndGet(KeyboardDriving.LEASE.toNanos() + 1);
            sent(run.operator().goTo("idle", new Pose2d(3, 0, 0)));
            done(run.operator().drive("idle", "me", Twist2d.STOP));
            handClock.addAndGet(KeyboardDriving.LEASE.toNanos() + 1);
            done(run.operator().drive("idle", "you", Twist2d.STOP));
            done(run.operator().release("idle", "you"));
        }
    }

    @Test
    void theEmergencyStopComesFirst() {
        drive("idle", Twist2d.drive(0.5, 0), 5);
        assertThat(answer(run.operator().estop())).isInstanceOf(Answer.Stopped.class);
        Pose2d stopped = pose(drive("idle", Twist2d.drive(0.5, 0), 3), "idle");
        assertThat(pose(drive("idle", Twist2d.drive(0.5, 0), 3), "idle")).isEqualTo(stopped);
        assertThat(answer(run.operator().rearm())).isInstanceOf(Answer.Armed.class);
        assertThat(pose(drive("idle", Twist2d.drive(0.5, 0), 5), "idle"))
                .as("with the key still down")
                .isEqualTo(stopped);
        drive("idle", Twist2d.STOP, 1);
        assertThat(pose(drive("idle", Twist2d.drive(0.5, 0), 8), "idle").distanceTo(stopped))
                .isGreaterThan(0.1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"wander", "wall-follow"})
    void aBehaviorIsGivenAndTakenAway(String behavior) {
        Pose2d start = pose(now(), "idle");
        done(run.operator().behave("idle", behavior));
        assertThat(robot(now(), "idle").behavior()).isEqualTo(behavior);
        assertThat(robot(now(), "idle").devices()).extracting(DeviceView::name).contains("pilot");
        go();
        await(s -> pose(s, "idle").distanceTo(start) > 1);
        assertThat(robot(now(), "idle").inCharge()).isNotEmpty();
        done(run.operator().behave("idle", ""));
        await(s -> robot(s, "idle").inCharge().isEmpty()
                && robot(s, "idle").odometry().orElseThrow().value().velocity().equals(Twist2d.STOP));
    }

    @Test
    void aRobotWithAnAgentCanBeAskedToStand() {
        go();
        await(s -> roams(robot(s, "roamer")));
        done(run.operator().behave("roamer", "stand"));
        Snapshot standing = await(s -> robot(s, "roamer").behavior().equals("stand")
                && robot(s, "roamer")
                        .odometry()
                        .orElseThrow()
                        .value()
                        .velocity()
                        .equals(Twist2d.STOP));
        assertThat(robot(standing, "roamer").inCharge()).isEmpty();
        done(run.operator().behave("roamer", ""));
        await(s -> roams(robot(s, "roamer")));
    }

    @Trials(
            value = {"idle, odometry", "drifter, amcl", "glider, odometry", "roamer, odometry"},
            landing = 2)
    void aRobotIsSentSomewhere(String id, String localizer) {
        assertThat(robot(now(), id).devices()).extracting(DeviceView::name).doesNotContain("localizer", "navigator");
        SentGoal sent = sent(run.operator().goTo(id, new Pose2d(0, 2, 0)));
        assertThat(sent.isInProgress()).isTrue();
        assertThat(sent.robot()).isEqualTo(id);
        go(10); // slowly enough to be seen on its way
        Snapshot going = await(s -> robot(s, id).goal().isPresent()
                && !robot(s, id).path().points().isEmpty()
                && robot(s, id).estimate().isPresent());
        assertThat(robot(going, id).inCharge()).isEqualTo("navigator");
        assertThat(robot(going, id).devices())
                .extracting(DeviceView::name, DeviceView::driver)
                .contains(org.assertj.core.groups.Tuple.tuple("localizer", localizer));
        run.speed(Double.POSITIVE_INFINITY);
        await(_ -> happened(id, "is at (0.00, 2.00, 0°)"));
        await(_ -> goal(sent.id()).status() == SentGoal.Status.SUCCEEDED);
        assertThat(goal(sent.id()).ended()).isPresent();
        if (id.equals("roamer")) {
            await(s -> roams(robot(s, id)));
        } else {
            assertThat(pose(now(), id).distanceTo(new Pose2d(0, 2, 0))).isLessThan(0.5);
        }
    }

    @Test
    void theNewestOrderCounts() {
        done(run.operator().behave("idle", "wander"));
        SentGoal first = sent(run.operator().goTo("idle", new Pose2d(3, 0, 0)));
        assertThat(robot(now(), "idle").behavior()).isEmpty();
        assertThat(robot(now(), "idle").goal()).contains(new Pose2d(3, 0, 0));
        SentGoal second = sent(run.operator().goTo("idle", new Pose2d(-3, 0, 0)));
        assertThat(second.id()).isEqualTo(first.id() + 1);
        assertThat(goal(first.id()).status()).isEqualTo(SentGoal.Status.CANCELED);
        assertThat(goal(first.id()).why()).isEqualTo("Another goal came.");
        assertThat(robot(now(), "idle").goal()).contains(new Pose2d(-3, 0, 0));
        done(run.operator().behave("idle", "wall-follow"));
        assertThat(goal(second.id()).status()).isEqualTo(SentGoal.Status.CANCELED);
        assertThat(robot(now(), "idle").goal()).isEmpty();
        assertThat(robot(now(), "idle").behavior()).isEqualTo("wall-follow");
        assertThat(happened("idle", "can't get")).isFalse();
    }

    @Test
    void aWayIsGoneOnWithWhenKeysAreLetGo() {
        sent(run.operator().goTo("idle", new Pose2d(3, 2, 0)));
        drive("idle", Twist2d.drive(-0.4, 0), 5);
        assertThat(pose(now(), "idle").x()).isLessThan(-4.05);
        assertThat(robot(now(), "idle").goal()).isPresent();
        done(run.operator().release("idle", "me"));
        go();
        await(_ -> happened("idle", "is at (3.00, 2.00, 0°)"));
    }

    @Test
    void whatARobotCantDoIsRefusedWithTheReason() {
        assertThat(refusal(run.operator().goTo("blind", new Pose2d(3, 0, 0))))
                .isEqualTo("Robot 'blind' can't be sent anywhere."
                        + " It has no sensor that measures ranges, so it would drive blindly.");
        assertThat(refusal(run.operator().behave("blind", "wander"))).contains("drive blindly");
        assertThat(refusal(run.operator().goTo("car", new Pose2d(3, 0, 0)))).contains("which a car 'cart' can't");
        assertThat(refusal(run.operator().behave("idle", "dance")))
                .isEqualTo("There is no behavior 'dance'; there are [stand, wander, wall-follow].");
        assertThat(refusal(run.operator().goTo("idle", new Pose2d(0, 0, 0))))
                .isEqualTo("There is a wall at (0.00, 0.00).");
        assertThat(refusal(run.operator().goTo("idle", new Pose2d(300, 0, 0))))
                .isEqualTo("(300.00, 0.00) is outside the map.");
        assertThat(refusal(run.operator().drive("nobody", "me", Twist2d.STOP))).contains("There is no 'nobody'");
        assertThat(refusal(run.operator().drive("idle", "me", Twist2d.drive(Double.NaN, 0))))
                .contains("finite");
        done(run.operator().drive("blind", "me", Twist2d.drive(0.1, 0)));
        done(run.operator().behave("car", "stand"));
    }

    @Test
    void aRobotThatIsPlacedByHandKnowsItOnItsWay() {
        sent(run.operator().goTo("drifter", new Pose2d(4, 1, 0)));
        done(run.operator().place("drifter", new Pose2d(-4, -1, 0)));
        go();
        await(_ -> happened("drifter", "is at (4.00, 1.00, 0°)"));
        assertThat(pose(now(), "drifter").distanceTo(new Pose2d(4, 1, 0))).isLessThan(0.7);
    }
}
