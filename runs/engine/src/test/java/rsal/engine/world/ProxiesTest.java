package rsal.engine.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.Covariance2d;
import rsal.data.GripperState;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.SensorCore;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Standing;
import rsal.device.SimulationControl.Thing;
import rsal.engine.Runs;
import rsal.engine.event.EventLog;
import rsal.engine.report.RunEvent;
import rsal.engine.report.Teammate;
import rsal.engine.robot.RobotPoses;
import rsal.engine.robot.RobotSystems;
import rsal.engine.robot.RobotTeam;
import rsal.robot.Robot;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.time.LockstepScheduler;

@Timeout(60)
class ProxiesTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: proxies
            world: {map: office}
            robots:
              rover: {model: pioneer2dx, pose: [-12, -1, 0], devices: {laser: urg04lx}}
              real: {model: pioneer2dx, pose: [-8, -1, 90], mrs: {use: reality}, proxy: true, color: "#ff0000", devices: {gripper: pioneer-gripper}}
            mrs: {odometryNoise: 0, sensorNoise: 0}
            """;

    private static final Pose2d THERE = new Pose2d(-10, -1, 0);

    @TempDir
    private Path folder;

    private final LockstepScheduler time = new LockstepScheduler(Instant.EPOCH, Runnable::run);
    private final RobotTeam team = new RobotTeam();
    private EventLog eventLog;
    private RunPlan plan;
    private RobotSystems systems;
    private Proxies proxies;
    private Oracle localizer;
    private List<Robot> found = List.of();

    /// Says where its robot is as it is told to.
    private final class Oracle extends SensorCore<PoseEstimate> implements Localizer {
        Oracle() {
            super(new DeviceInfo("real", "localizer", "oracle"));
        }

        void publish(Pose2d mapFromBase) {
            var estimate = PoseEstimate.of(mapFromBase, Covariance2d.ofDeviations(0.1, 0.1, 0.1));
            deliver(new Stamped<>(time.instant(), "map", estimate));
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            return CompletableFuture.completedStage(null);
        }
    }

    /// Holds something when it is told to.
    private final class Paw extends SensorCore<GripperState> implements Gripper {
        Paw() {
            super(new DeviceInfo("real", "gripper", "paw"));
        }

        void show(boolean holding, double raised) {
            var state = new GripperState(
                    holding ? GripperState.Paddles.CLOSED : GripperState.Paddles.OPEN,
                    holding ? 0.5 : 0,
                    GripperState.Lift.STOPPED,
                    raised,
                    holding,
                    false,
                    holding,
                    holding,
                    holding);
            deliver(new Stamped<>(time.instant(), "real/gripper", state));
        }

        @Override
        public GoalHandle<GripperState, Result> open() {
            throw new AssertionError();
        }

        @Override
        public GoalHandle<GripperState, Result> close() {
            throw new AssertionError();
        }

        @Override
        public GoalHandle<GripperState, Result> lift() {
            throw new AssertionError();
        }

        @Override
        public GoalHandle<GripperState, Result> lower() {
            throw new AssertionError();
        }
    }

    @BeforeEach
    void begin() {
        plan = Runs.plan(folder, SCENARIO, RunOptions.NONE);
        systems = new RobotSystems(plan, time);
        eventLog = new EventLog(() -> Duration.between(Instant.EPOCH, time.instant()), () -> {});
        proxies = new Proxies(systems, team, new RobotPoses(systems, team), time, eventLog);
        localizer = new Oracle();
        CompletionStage<List<Robot>> search = systems.discover();
        seconds(0.1);
        found = search.toCompletableFuture().getNow(List.of());
    }

    @AfterEach
    void end() {
        systems.close();
    }

    private void seconds(double seconds) {
        time.advance(Duration.ofMillis(Math.round(seconds * 1000)));
    }

    private Robot found(String id) {
        return found.stream().filter(robot -> robot.id().equals(id)).findFirst().orElseThrow();
    }

    private Robot join(Robot robot) {
        PlannedRobot planned = plan.robots().stream()
                .filter(one -> one.spec().id().equals(robot.id()))
                .findFirst()
                .orElseThrow();
        team.join(robot, Optional.empty(), new Teammate(planned.spec(), Optional.empty()));
        proxies.join(planned);
        return robot;
    }

    private void joinWithLocalizer() {
        join(found("real").with(localizer));
    }

    /// What the stand-in had people told.
    private List<String> reported() {
        return eventLog.after(0).stream()
                .filter(event -> event.kind().equals("proxy") && event.subject().equals("real"))
                .map(RunEvent::text)
                .toList();
    }

    private SimulationControl world() {
        return systems.simulation().orElseThrow();
    }

    private Optional<Pose2d> proxy() {
        return world().truth("real");
    }

    @Test
    void standsWhereItsLocalizerSaysOnceThatSaysAnything() {
        joinWithLocalizer();
        seconds(0.5);
        assertThat(proxy()).isEmpty();
        localizer.publish(THERE);
        seconds(0.05);
        assertThat(proxy()).as("every 0.1 s").isEmpty();
        seconds(0.05);
        assertThat(proxy()).contains(THERE);
        assertThat(systems.truth("real")).as("nobody knows the truth").isEmpty();
        localizer.publish(new Pose2d(-9.5, -1, 1));
        seconds(0.1);
        assertThat(proxy()).contains(new Pose2d(-9.5, -1, 1));
        assertThat(reported()).isEmpty();
    }

    @Test
    void simulatedRobotsSeeItAndRunIntoIt() {
        Robot rover = join(found("rover"));
        joinWithLocalizer();
        LaserScanner laser = rover.require(LaserScanner.class);
        seconds(0.5);
        assertThat(ahead(laser)).isGreaterThan(4);
        localizer.publish(THERE);
        seconds(0.3);
        assertThat(ahead(laser)).isBetween(1.3f, 2f);
        for (int i = 0; i < 80; i++) {
            rover.require(DriveBase.class).command(Twist2d.drive(0.4, 0));
            localizer.publish(THERE);
            seconds(0.1);
        }
        assertThat(systems.truth("rover").orElseThrow().distanceTo(THERE)).isBetween(0.3, 0.6);
        assertThat(world().contacts())
                .singleElement()
                .satisfies(contact -> assertThat(contact.other()).isEqualTo("real"));
        assertThat(world().things())
                .singleElement()
                .satisfies(thing -> assertThat(thing.body().pieces())
                        .allSatisfy(piece -> assertThat(piece.color()).contains(new Rgb(255, 0, 0))));
    }

    private static float ahead(LaserScanner laser) {
        float[] ranges = laser.latest().orElseThrow().value().ranges();
        return ranges[ranges.length / 2];
    }

    @Test
    void standsAlsoWhereThereIsNoRoom() {
        join(found("rover"));
        joinWithLocalizer();
        for (Pose2d there : List.of(new Pose2d(-12, -1, 0), new Pose2d(-12, -2.4, 0))) {
            localizer.publish(there);
            seconds(0.1);
            assertThat(proxy()).contains(there);
        }
    }

    @Test
    void isNowhereWhenItsRobotIsOutsideOfTheWorldOrHasLeft() {
        joinWithLocalizer();
        localizer.publish(THERE);
        seconds(0.1);
        for (int i = 0; i < 3; i++) {
            localizer.publish(new Pose2d(-10, -100 - i, 0));
            seconds(0.1);
        }
        assertThat(proxy()).isEmpty();
        assertThat(reported())
                .containsExactly(
                        "can't stand in the simulated world: (-10.00, -100.00) is outside of the world, which reaches from"
                                + " (-31.48, -7.80) to (31.48, 7.80).",
                        "jumped by 99.0 m");
        localizer.publish(THERE);
        seconds(0.1);
        assertThat(proxy()).contains(THERE);
        proxies.leave("real");
        localizer.publish(THERE);
        seconds(0.2);
        assertThat(proxy()).isEmpty();
    }

    @Test
    void staysAndIsStaleWhenNobodyReportsForASecond() {
        joinWithLocalizer();
        localizer.publish(THERE);
        seconds(1.1);
        assertThat(reported()).isEmpty();
        seconds(3);
        assertThat(proxy()).contains(THERE);
        localizer.publish(THERE);
        seconds(0.1);
        assertThat(reported())
                .containsExactly(
                        "is stale: for more than 1 s nobody has told where it is", "is where it is told to be again");
    }

    @Test
    void jumpsAreReported() {
        joinWithLocalizer();
        for (double x : new double[] {-10, -9.1, -7.8, -7.8}) {
            localizer.publish(new Pose2d(x, -1, 0));
            seconds(0.1);
        }
        assertThat(reported()).containsExactly("jumped by 1.3 m");
    }

    /// A can, or what only looks like one.
    private void put(String name, double x, boolean grippable) {
        Thing can = Thing.of(
                name,
                new Pose2d(x, -1, 0),
                Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.08), 0.1),
                new Rgb(0, 200, 0));
        assertThat(world().add(grippable ? can.asGrippable() : can)).isInstanceOf(Placement.Placed.class);
    }

    private Paw joinWithGripper() {
        var paw = new Paw();
        Robot real = found("real").with(localizer);
        join(real.replacing(real.require(Gripper.class), paw));
        localizer.publish(THERE);
        return paw;
    }

    private Standing thing(String name) {
        return world().things().stream()
                .filter(one -> one.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void takesAlongWhatItsRobotHasGrippedAndPutsItDownWhereThatDoes() {
        put("near", -9.4, true);
        put("nearer", -9.6, true);
        put("paper", -9.75, false);
        Paw paw = joinWithGripper();
        paw.show(false, 0);
        seconds(0.2);
        assertThat(thing("nearer").mapFromThing()).isEqualTo(new Pose2d(-9.6, -1, 0));
        paw.show(true, 0);
        seconds(0.1);
        assertThat(thing("nearer").mapFromThing().x()).as("between the paddles").isCloseTo(-9.77, within(1e-9));
        assertThat(proxies.names()).containsExactlyInAnyOrder("real", "nearer");
        localizer.publish(new Pose2d(-9, -1, 0));
        paw.show(true, 0.5);
        seconds(0.1);
        assertThat(thing("nearer").mapFromThing().x()).isCloseTo(-8.77, within(1e-9));
        assertThat(thing("nearer").height()).isCloseTo(0.1, within(1e-9));
        paw.show(false, 0.5);
        seconds(0.1);
        localizer.publish(THERE);
        seconds(0.1);
        assertThat(thing("nearer").mapFromThing().x()).isCloseTo(-8.77, within(1e-9));
        assertThat(thing("nearer").height()).isZero();
        assertThat(proxies.names()).containsExactly("real");
        assertThat(thing("near").mapFromThing()).isEqualTo(new Pose2d(-9.4, -1, 0));
        assertThat(reported()).containsExactly("takes 'nearer' along", "puts 'nearer' down");
    }

    @Test
    void whatTheSimulatedWorldHasNotIsNotTakenAlong() {
        put("far", -9.2, true);
        Paw paw = joinWithGripper();
        paw.show(true, 1);
        seconds(0.3);
        assertThat(thing("far").mapFromThing()).isEqualTo(new Pose2d(-9.2, -1, 0));
        paw.show(false, 1);
        seconds(0.1);
        assertThat(reported()).containsExactly("has gripped something that is not in the simulated world");
    }

    @Test
    void whenItsRobotHasLeftWhatWasTakenAlongLiesWhereItWas() {
        put("can", -9.8, true);
        Paw paw = joinWithGripper();
        paw.show(true, 1);
        seconds(0.1);
        assertThat(thing("can").height()).isPositive();
        proxies.leave("real");
        assertThat(thing("can").height()).isZero();
    }

    @Test
    void withoutALocalizerItGoesByOdometryFromItsStart() {
        Robot real = found("real");
        for (int i = 0; i < 10; i++) { // before it takes part, which is no matter of the run
            real.require(DriveBase.class).command(Twist2d.drive(0.4, 0.5));
            seconds(0.1);
        }
        seconds(1);
        join(real);
        seconds(0.1);
        assertThat(proxy().orElseThrow().isNear(Pose2d.ofDegrees(-8, -1, 90), 1e-9, 1e-9))
                .isTrue();
        for (int i = 0; i < 20; i++) {
            real.require(DriveBase.class).command(Twist2d.drive(0.4, 0));
            seconds(0.1);
        }
        Pose2d startFromNow = Pose2d.ofDegrees(-8, -1, 90).inverse().compose(proxy().orElseThrow());
        assertThat(startFromNow.x()).isBetween(0.5, 0.9);
        assertThat(Math.abs(startFromNow.y())).isLessThan(1e-9);
    }
}
