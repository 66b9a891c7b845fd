package rsal.player.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.data.Twist2d;
import rsal.device.GoalHandle;
import rsal.device.Health;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.player.client.ScriptedServer;
import rsal.player.message.Interface;
import rsal.player.message.Localize;
import rsal.player.message.PlannerInterface;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.RobotModel;

/// A robot that brings its own localizer and planner, whose server says what a test has it say.
@Timeout(60)
class OwnPlannerTest extends ScriptedBench {
    private static final Address BASE = Address.of(Interface.POSITION2D.code(), 0);
    private static final Address PLANNER = Address.of(Interface.PLANNER.code(), 0);
    private static final Address LOCALIZER = Address.of(Interface.LOCALIZE.code(), 0);
    private static final Pose2d GOAL = new Pose2d(5, 0, 0);
    private static final Tolerance NEAR = new Tolerance(0.2, 0.2);

    private final BlockingQueue<Packet> heard = new LinkedBlockingQueue<>(); // of the base and the planner
    private PlayerBase base;
    private PlayerNavigator navigator;
    private PlayerLocalizer localizer;
    private volatile List<Localize.Particle> particles = List.of();
    private volatile List<Pose> waypoints = List.of();

    OwnPlannerTest() {
        super(BASE, PLANNER, LOCALIZER);
    }

    private void begin(boolean armed) throws IOException {
        meet();
        awaitKnown();
        CompletableFuture<Void> all = on(() -> {
            var drive = new RobotModel.Drive(1, 1, 1, 1, new RobotModel.OdometryNoise(0, 0, 0));
            base = new PlayerBase(info("base"), BASE, remote, drive, Duration.ofMillis(500), armed, time);
            navigator = new PlayerNavigator(info("navigator"), PLANNER, remote, base, time);
            localizer = new PlayerLocalizer(info("localizer"), LOCALIZER, remote, base, time);
            return CompletableFuture.allOf(
                    remote.add(base).toCompletableFuture(),
                    remote.add(navigator).toCompletableFuture(),
                    remote.add(localizer).toCompletableFuture());
        });
        all.join();
    }

    private void meet() throws IOException {
        accept(IDENT);
        ScriptedServer.Client to = client;
        Thread.ofVirtual().start(() -> {
            try {
                while (true) {
                    answer(to, to.next());
                }
            } catch (IOException | RuntimeException e) {
                // it has gone
            }
        });
    }

    private void answer(ScriptedServer.Client to, Packet packet) throws IOException {
        Address from = packet.header().address();
        int subtype = packet.header().subtype();
        if (from.equals(Session.SERVER) && subtype == Session.DEVICES) {
            to.acknowledge(packet, new Session.Devices(List.of(BASE, PLANNER, LOCALIZER)));
        } else if (from.equals(Session.SERVER) && subtype == Session.DEVICE) {
            to.acknowledge(packet, packet.body(Session.Subscription.class));
        } else if (from.equals(LOCALIZER)) {
            to.acknowledge(packet, new Localize.Particles(new Pose(0, 0, 0), 0, particles));
        } else if (from.equals(PLANNER)
                && packet.header().kind() == MessageKind.REQUEST
                && subtype == PlannerInterface.WAYPOINTS) {
            to.acknowledge(packet, new PlannerInterface.Waypoints(0, waypoints));
        } else {
            if (!from.equals(Session.SERVER)) {
                heard.add(packet);
            }
            if (packet.header().kind() == MessageKind.REQUEST) {
                to.acknowledge(packet);
            }
        }
    }

    private GoalHandle<Progress, Result> go(Pose2d goal) {
        return on(() -> navigator.goTo(goal, NEAR));
    }

    private void arm(boolean on) {
        run(() -> {
            base.enable(on);
        });
    }

    /// What the planner hears next.
    private String order() throws Exception {
        Packet packet = heard.poll(10, TimeUnit.SECONDS);
        while (packet != null && !packet.header().address().equals(PLANNER)) {
            packet = heard.poll(10, TimeUnit.SECONDS);
        }
        assertThat(packet).isNotNull();
        return words(packet);
    }

    private static String words(Packet packet) throws IOException {
        return packet.header().kind() == MessageKind.COMMAND
                ? "goal "
                        + packet.body(PlannerInterface.Place.class)
                                .mapFromPlace()
                                .x()
                : "enable " + packet.body(PlannerInterface.Enable.class).on();
    }

    private List<String> ordersSoFar() throws Exception {
        remote.settled().toCompletableFuture().join();
        var packets = new ArrayList<Packet>();
        heard.drainTo(packets);
        var words = new ArrayList<String>();
        for (Packet packet : packets) {
            if (packet.header().address().equals(PLANNER)) {
                words.add(words(packet));
            }
        }
        return words;
    }

    private void reported(double x, Pose2d goal, boolean done) throws IOException {
        var state = new PlannerInterface.State(
                1, done ? 1 : 0, new Pose(x, 0, 0), Pose.of(goal), new Pose(x + 1, 0, 0), done ? -1 : 0, done ? 0 : 3);
        client.send(Packet.of(PLANNER, MessageKind.DATA, PlannerInterface.STATE, 0, state));
    }

    private void settle() {
        remote.settled().toCompletableFuture().join();
        on(() -> true);
        on(() -> true);
    }

    @Test
    void theFirstGoalOfAConnectionSwitchesThePlannerOn() throws Exception {
        begin(true);
        go(GOAL);
        assertThat(order()).isEqualTo("goal 5.0");
        assertThat(order()).isEqualTo("enable 1");
    }

    @Test
    void itDrivesNowhereBeforeItIsArmed() throws Exception {
        begin(false);
        GoalHandle<Progress, Result> going = go(GOAL);
        reported(0, new Pose2d(1, 1, 1), false);
        settle();
        assertThat(ordersSoFar()).containsOnly("enable 0");
        assertThat(on(() -> going.result().toCompletableFuture().isDone())).isFalse();
        arm(true);
        assertThat(order()).isEqualTo("goal 5.0");
        assertThat(order()).isEqualTo("enable 1");
    }

    @Test
    void whoSwitchesTheMotorsOffSwitchesThePlannerOff() throws Exception {
        begin(true);
        GoalHandle<Progress, Result> going = go(GOAL);
        assertThat(order()).isEqualTo("goal 5.0");
        assertThat(order()).isEqualTo("enable 1");
        arm(false);
        assertThat(order()).isEqualTo("enable 0");
        arm(true);
        assertThat(order()).isEqualTo("goal 5.0"); // once more, as it may have been forgotten
        assertThat(order()).isEqualTo("enable 1");
        assertThat(on(() -> going.result().toCompletableFuture().isDone())).isFalse();
        run(() -> {
            navigator.end();
        });
        assertThat(order()).isEqualTo("enable 0");
    }

    @Test
    void aGoalOfALostServerIsNotDrivenToWhenItIsBack() throws Exception {
        begin(true);
        GoalHandle<Progress, Result> going = go(GOAL);
        assertThat(order()).isEqualTo("goal 5.0");
        assertThat(order()).isEqualTo("enable 1");
        client.close();
        assertThat(result(going)).isInstanceOf(Result.Stuck.class);
        meet();
        assertThat(order()).isEqualTo("enable 0");
        go(new Pose2d(2, 0, 0));
        assertThat(order()).isEqualTo("goal 2.0");
        assertThat(order()).isEqualTo("enable 1");
    }

    @Test
    void aRobotThatDroveWhenItsServerWasLostIsStoppedWhenThatIsBack() throws Exception {
        begin(true);
        run(() -> {
            base.command(Twist2d.drive(0.4, 0));
        });
        assertThat(speed()).isEqualTo(0.4);
        client.close();
        meet();
        assertThat(speed()).isZero();
    }

    /// That the base is told next.
    private double speed() throws Exception {
        Packet packet = heard.poll(10, TimeUnit.SECONDS);
        while (packet != null && packet.header().kind() != MessageKind.COMMAND) {
            packet = heard.poll(10, TimeUnit.SECONDS);
        }
        assertThat(packet).isNotNull();
        return packet.body(Position2d.Velocity.class).velocity().x();
    }

    @Test
    void whatIsCalledOffIsSwitchedOffHoweverOftenThatWasSaid() throws Exception {
        begin(true);
        run(() -> {
            navigator.pause();
            navigator.pause();
        });
        assertThat(order()).isEqualTo("enable 0");
        assertThat(order()).as("others may have switched it on").isEqualTo("enable 0");
    }

    @Test
    void doneIsOfThisGoalOnceThePlannerWasUnderWay() throws Exception {
        begin(true);
        GoalHandle<Progress, Result> going = go(GOAL);
        reported(0, GOAL, true); // as it was with the goal before: it has not planned yet
        settle();
        assertThat(on(() -> going.result().toCompletableFuture().isDone())).isFalse();
        reported(1, GOAL, false);
        settle(); // the newest counts
        reported(3.9, GOAL, true);
        assertThat(result(going)).isInstanceOf(Result.Reached.class);
        assertThat(ordersSoFar()).as("others may use it, too").doesNotContain("enable 0");
    }

    @Test
    void doneCloseToTheGoalIsBelievedAtOnce() throws Exception {
        begin(true);
        GoalHandle<Progress, Result> going = go(GOAL);
        reported(4.5, GOAL, true);
        assertThat(result(going)).isInstanceOf(Result.Reached.class);
    }

    private Result result(GoalHandle<Progress, Result> going) {
        return going.result()
                .toCompletableFuture()
                .orTimeout(10, TimeUnit.SECONDS)
                .join();
    }

    @Test
    void theWayBeginsWithTheWaypointThatItDrivesTo() throws Exception {
        begin(true);
        go(GOAL);
        reported(0, GOAL, false);
        settle();
        assertThat(on(navigator::path).points()).extracting(point -> point.x()).startsWith(0.0, 1.0);
    }

    @Test
    void aSlowRobotOnALongWayIsNotStuckUntilItStands() throws Exception {
        begin(true);
        waypoints = List.of(new Pose(40, 0, 0), new Pose(40, 5, 0), new Pose(5, 5, 0));
        var goal = new Pose2d(0, 5, 0); // 5 m away, behind a wall that is as long as the way
        GoalHandle<Progress, Result> going = go(goal);
        Instant begun = time.instant();
        drive(begun, 0, goal);
        until( // it has been asked for the whole way
                () -> {
                    navigator.look(time.instant());
                    return navigator.path();
                },
                path -> path.points().size() >= 4);
        for (int second = 1; second <= 150; second++) {
            drive(begun.plusSeconds(second), 0.2 * second, goal);
        }
        assertThat(on(() -> going.result().toCompletableFuture().isDone())).isFalse();
        for (int second = 151; second <= 215; second++) {
            drive(begun.plusSeconds(second), 30, goal);
        }
        assertThat(result(going)).isInstanceOf(Result.Stuck.class);
    }

    private void drive(Instant now, double x, Pose2d goal) {
        var state = new PlannerInterface.State(1, 0, new Pose(x, 0, 0), Pose.of(goal), waypoints.getFirst(), 1, 3);
        run(() -> {
            navigator.take(now, state);
        });
    }

    @Test
    void aLocalizerThatSaysNothingIsAskedWhatItBelieves() throws Exception {
        particles = List.of(
                new Localize.Particle(new Pose(1, 2, Math.PI - 0.1), 1),
                new Localize.Particle(new Pose(1.2, 2, -Math.PI + 0.1), 1));
        begin(true);
        PoseEstimate estimate =
                until(localizer::latest, Optional::isPresent).orElseThrow().value();
        assertThat(estimate.mapFromBase().isNear(new Pose2d(1.1, 2, Math.PI), 1e-9, 1e-9))
                .isTrue();
        assertThat(estimate.covariance().xx()).isCloseTo(0.01, within(1e-9));
        assertThat(estimate.covariance().thetaTheta()).isCloseTo(0.01, within(1e-9));
        assertThat(estimate.quality()).isEqualTo(Quality.LOCALIZED);
    }

    @Test
    void aLocalizerThatSaysNothingOnALongWayIsBelievedNoMoreUntilItSaysSomething() throws Exception {
        particles = List.of(new Localize.Particle(new Pose(1, 2, 0), 1));
        begin(true);
        until(localizer::latest, Optional::isPresent);
        Instant begun = time.instant();
        odometry(begun, 0);
        odometry(begun.plusSeconds(1), 2);
        assertThat(on(localizer::latest).orElseThrow().value().mapFromBase()).isEqualTo(new Pose2d(3, 2, 0));
        odometry(begun.plusSeconds(2), 0); // and back
        assertThat(on(localizer::health)).isInstanceOf(Health.Stale.class);
        assertThat(on(localizer::latest).orElseThrow().value().mapFromBase()).isEqualTo(new Pose2d(3, 2, 0));
        var hypothesis = new Localize.Hypothesis(new Pose(1.5, 2, 0), new double[6], 1);
        run(() -> localizer.take(
                begun.plusSeconds(3), new Localize.Hypotheses(0, begun.getEpochSecond(), List.of(hypothesis))));
        assertThat(on(localizer::health)).isEqualTo(Health.ok());
        assertThat(on(localizer::latest).orElseThrow().value().mapFromBase()).isEqualTo(new Pose2d(1.5, 2, 0));
    }

    private void odometry(Instant now, double x) {
        var state = new Position2d.State(new Pose(x, 0, 0), new Pose(0, 0, 0), 0);
        run(() -> base.take(now, state));
    }
}
