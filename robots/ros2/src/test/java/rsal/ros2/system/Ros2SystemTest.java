package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.model.RobotModels;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTransform.Quaternion;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.RealRobots.Waiting;
import rsal.system.RobotSystem.Change;
import rsal.system.RobotSystemProvider.Config;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.testkit.contract.RobotBench;
import rsal.time.LockstepScheduler;

/// Robots whose topics the test publishes itself.
class Ros2SystemTest {
    private static final Duration STEP = Duration.ofMillis(50);
    private static final Instant STAMP = Instant.ofEpochSecond(1_700_000_000); // the robot's clock is another one

    private static final Location HERE = Location.of("test");

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<Twist2d> commanded = new ArrayList<>();
    private final List<Change> changes = new ArrayList<>();
    private Publication odometry;
    private Publication scans;

    private static RobotSpec spec(String id) {
        return new RobotSpec(
                id,
                "tested",
                new RobotModels(FileSource.resources(RobotBench.class, "/"))
                        .read("pioneer2dx", HERE, Map.of("laser", new RobotModels.Choice("urg04lx", HERE))),
                Optional.empty(),
                "#3366cc");
    }

    private void robotIsThere(String commandType) {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        scans = there.advertise(new RosTopic("/r1/scan", "sensor_msgs/msg/LaserScan"), Profile.SENSOR_DATA);
        there.subscribe(new RosTopic("/r1/cmd_vel", commandType), Profile.DEFAULT, bytes -> hear(commandType, bytes));
    }

    private void hear(String type, ByteBuffer bytes) {
        try {
            CdrReader reader = CdrReader.of(bytes);
            if (type.endsWith("Stamped")) {
                reader.skip(4, 2);
                reader.text();
            }
            double vx = reader.float64();
            reader.skip(8, 4);
            commanded.add(new Twist2d(vx, 0, reader.float64()));
        } catch (InvalidCdr e) {
            throw new AssertionError(e);
        }
    }

    private Ros2System system() {
        return system(Map.of(spec("r1"), "/r1"), Waiting.USUAL);
    }

    private Ros2System system(Map<RobotSpec, String> namespaces, Waiting waiting) {
        var system = new Ros2System(
                namespaces,
                "domain 0",
                network::join,
                Optional.empty(),
                new RosSettings(
                        new Safety(Duration.ofMillis(500), true, "e_stop", "set_e_stop"),
                        GripperSettings.USUAL,
                        List.of(),
                        true,
                        false),
                waiting,
                run,
                new SplittableRandom(1));
        system.onChange(changes::add);
        return system;
    }

    /// By the robot's clock.
    private Instant stamp() {
        return STAMP.plus(Duration.between(Instant.EPOCH, run.instant()));
    }

    private void advance(double seconds, boolean publishes) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            if (publishes) {
                Instant stamp = stamp();
                odometry.publish(messages.odometry(
                        stamp, new Odometry(new Pose2d(1, 2, 0.5), Twist2d.STOP, false), "odom", "base_footprint"));
                var scan = new LaserScan(Pose2d.ORIGIN, -1, 0.5, 0.1, 5, new float[] {1, 2, 3, 4, 9});
                scans.publish(messages.scan(stamp, scan, "laser_link", 0.05));
            }
            run.advance(STEP);
        }
    }

    private Robot found(Ros2System system) {
        CompletableFuture<List<Robot>> found = system.discover().toCompletableFuture();
        advance(3, true);
        return found.join().getFirst();
    }

    @ParameterizedTest
    @ValueSource(strings = {"geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"})
    void aRobotIsDrivenByWhateverVelocityItTakes(String type) {
        robotIsThere(type);
        try (Ros2System system = system()) {
            Robot robot = found(system);
            commanded.clear();
            robot.require(DriveBase.class).command(new Twist2d(0.3, 0, 0.2));
            advance(0.3, true);
            assertThat(commanded).hasSizeBetween(2, 5).containsOnly(new Twist2d(0.3, 0, 0.2));
            advance(0.5, true); // nobody commands any more
            commanded.clear();
            advance(0.2, true);
            assertThat(commanded).hasSizeGreaterThan(2).containsOnly(Twist2d.STOP); // as one can get lost
            advance(0.5, true);
            commanded.clear();
            advance(2, true);
            assertThat(commanded).isEmpty();
        }
        assertThat(commanded).last().isEqualTo(Twist2d.STOP);
    }

    /// It may drive on with what it heard last, as after an outage of a network.
    @Test
    void aRobotThatIsThereAgainIsStoppedUnlessItIsDriven() {
        robotIsThere("geometry_msgs/msg/Twist");
        try (Ros2System system = system()) {
            DriveBase base = found(system).require(DriveBase.class);
            comesAgain(); // and nobody has used it
            assertThat(commanded).isEmpty();
            base.command(new Twist2d(0.3, 0, 0));
            comesAgain();
            assertThat(commanded).hasSizeGreaterThan(5).containsOnly(Twist2d.STOP);
            comesAgain();
            base.command(new Twist2d(0.3, 0, 0));
            commanded.clear();
            advance(0.3, true);
            assertThat(commanded).isNotEmpty().containsOnly(new Twist2d(0.3, 0, 0));
            advance(4, true);
            commanded.clear();
            advance(1, true);
            assertThat(commanded).isEmpty();
        }
    }

    /// After 5 s.
    private void comesAgain() {
        odometry.close();
        advance(5, false);
        commanded.clear();
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        advance(0.5, true);
    }

    @Test
    void readingsHaveTheTimeOfTheRunAndThePlaceOfTf() {
        robotIsThere("geometry_msgs/msg/Twist");
        Publication fixed = there.advertise(new RosTopic("/r1/tf_static", "tf2_msgs/msg/TFMessage"), Profile.LATCHED);
        var upsideDown = new FrameTransform(0.2, 0, 0.3, new Quaternion(1, 0, 0, 0));
        fixed.publish(messages.transforms(List.of(
                new Transform(STAMP, "base_footprint", "base_link", FrameTransform.NONE),
                new Transform(STAMP, "base_link", "laser_link", upsideDown))));
        try (Ros2System system = system()) {
            Robot robot = found(system);
            advance(1, true);
            var scan = robot.require(LaserScanner.class).latest().orElseThrow();
            assertThat(scan.frame()).isEqualTo("r1/laser");
            assertThat(Duration.between(scan.time(), run.instant()).abs()).isLessThan(Duration.ofMillis(120));
            assertThat(scan.value().baseFromLaser()).isEqualTo(new Pose2d(0.2, 0, 0));
            assertThat(scan.value().ranges()).containsExactly(Float.POSITIVE_INFINITY, 4, 3, 2, 1);
            assertThat(robot.require(DriveBase.class)
                            .latest()
                            .orElseThrow()
                            .value()
                            .odomFromBase())
                    .satisfies(pose ->
                            assertThat(pose.distanceTo(new Pose2d(1, 2, 0))).isLessThan(1e-9));
        }
    }

    /// Its laser is on a joint that turns, and whose transforms come a bit later than the scans.
    @Test
    void aLaserOnAJointIsWhereTheJointWas() {
        robotIsThere("geometry_msgs/msg/Twist");
        Publication moving = there.advertise(new RosTopic("/r1/tf", "tf2_msgs/msg/TFMessage"), Profile.DEFAULT);
        try (Ros2System system = system()) {
            LaserScanner laser = found(system).require(LaserScanner.class);
            for (int i = 1; i <= 20; i++) {
                turn(moving, i * 0.05);
                advance(0.1, true);
            }
            assertThat(laser.latest().orElseThrow().value().baseFromLaser().theta())
                    .isBetween(0.8, 1.0);
            advance(0.8, true); // its joint is silent
            assertThat(laser.health())
                    .isInstanceOfSatisfying(
                            Health.Stale.class,
                            stale -> assertThat(stale.reason())
                                    .startsWith("What comes on /r1/scan is left out. The frame 'laser_link' has"));
            turn(moving, 0.3);
            advance(0.2, true);
            assertThat(laser.health().isOk()).isTrue();
        }
    }

    private void turn(Publication moving, double angle) {
        FrameTransform turned = FrameTransform.of(new Pose2d(0.1, 0, angle));
        moving.publish(messages.transforms(List.of(new Transform(stamp(), "base_footprint", "laser_link", turned))));
    }

    /// The robot itself is told, and those who come late, too.
    @Test
    void motorsThatAreSwitchedOffStopTheRobotByItsTopicAndService() {
        var reported = new ArrayList<Byte>();
        var called = new ArrayList<Byte>();
        network.serve("/r1/set_e_stop", request -> {
            called.add(request[4]);
            return CompletableFuture.completedStage(
                    new CdrWriter().bool(true).text("").toBytes());
        });
        robotIsThere("geometry_msgs/msg/Twist");
        try (Ros2System system = system()) {
            DriveBase base = found(system).require(DriveBase.class);
            base.enable(false);
            there.subscribe(
                    new RosTopic("/r1/e_stop", "std_msgs/msg/Bool"),
                    Profile.LATCHED,
                    bytes -> reported.add(bytes.get(4)));
            base.enable(true);
            assertThat(reported).containsExactly((byte) 1, (byte) 0);
            assertThat(called).containsExactly((byte) 0, (byte) 1, (byte) 0); // armed at first
        }
    }

    @Test
    void silenceIsStaleWithinAFewTenthsOfASecond() {
        robotIsThere("geometry_msgs/msg/Twist");
        try (Ros2System system = system()) {
            Robot robot = found(system);
            assertThat(robot.require(LaserScanner.class).health().isOk()).isTrue();
            advance(0.65, false);
            assertThat(robot.require(LaserScanner.class).health()).isInstanceOf(Health.Stale.class);
            Health silent = robot.require(DriveBase.class).health();
            assertThat(silent).isInstanceOf(Health.Stale.class);
            advance(3, false);
            assertThat(robot.require(DriveBase.class).health()).isEqualTo(silent); // which is told once
            advance(0.2, true);
            assertThat(robot.require(LaserScanner.class).health().isOk()).isTrue();
        }
    }

    @Test
    void aRobotThatLeavesIsGoneAndAppearsAgain() {
        robotIsThere("geometry_msgs/msg/Twist");
        try (Ros2System system = system()) {
            Robot robot = found(system);
            odometry.close();
            scans.close();
            advance(0.2, false);
            assertThat(changes).hasSize(1).first().isInstanceOf(Change.Gone.class);
            assertThat(robot.require(LaserScanner.class).health()).isInstanceOf(Health.Lost.class);
            robotIsThere("geometry_msgs/msg/Twist");
            advance(0.2, true);
            assertThat(changes).hasSize(2).last().isInstanceOf(Change.Appeared.class);
            assertThat(robot.require(LaserScanner.class).health().isOk()).isTrue();
        }
    }

    @Test
    void whoIsNotThereIsMissedWithWhatThereIs() {
        there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        try (Ros2System system = system()) {
            CompletableFuture<List<Robot>> found = system.discover().toCompletableFuture();
            advance(9, false);
            assertThatThrownBy(found::join)
                    .hasMessageContaining("Robot 'r1' was not found in the namespace '/r1'")
                    .hasMessageContaining("it lacks a subscriber of 'cmd_vel' (geometry_msgs/msg/Twist or")
                    .hasMessageContaining("Its namespace has '/r1/odom' (nav_msgs/msg/Odometry).");
        }
    }

    @Test
    void theLimitOfDiscoveryIsNeverReached() {
        try (Ros2System system = system()) {
            CompletableFuture<List<Robot>> found = system.discover().toCompletableFuture();
            advance(system.discoveryLimit().toMillis() / 1000.0 - 1, false);
            assertThat(found).isCompletedExceptionally();
        }
    }

    @Test
    void robotsMayJoinLate() {
        var waiting = new Waiting(Duration.ofSeconds(3), true);
        try (Ros2System system = system(Map.of(spec("r1"), "/r1"), waiting)) {
            assertThat(system.admitsLateRobots()).isTrue();
            CompletableFuture<List<Robot>> found = system.discover().toCompletableFuture();
            advance(4, false);
            assertThat(found.join()).isEmpty();
            assertThat(changes).isEmpty();
            robotIsThere("geometry_msgs/msg/Twist");
            advance(1, false);
            assertThat(changes).isEmpty(); // as it has published no odometry yet
            advance(3, true);
            assertThat(changes).singleElement().isInstanceOfSatisfying(Change.Appeared.class, change -> {
                assertThat(change.robot().id()).isEqualTo("r1");
                assertThat(change.robot().require(LaserScanner.class).latest()).isPresent();
            });
            odometry.close();
            scans.close();
            advance(0.2, false);
            assertThat(changes).hasSize(2).last().isInstanceOf(Change.Gone.class);
        }
    }

    @Test
    void thoseThatAreThereAreNotReportedTwice() {
        robotIsThere("geometry_msgs/msg/Twist");
        var waiting = new Waiting(Duration.ofSeconds(3), true);
        try (Ros2System system = system(Map.of(spec("r1"), "/r1", spec("r2"), "/r2"), waiting)) {
            CompletableFuture<List<Robot>> found = system.discover().toCompletableFuture();
            advance(8, true);
            assertThat(found.join()).extracting(Robot::id).containsExactly("r1");
            assertThat(changes).isEmpty();
        }
    }

    /// What is not a message is left out, and the next one is read.
    @Test
    void malformedMessagesDisturbNobody() {
        robotIsThere("geometry_msgs/msg/Twist");
        try (Ros2System system = system()) {
            Robot robot = found(system);
            for (byte[] bytes : List.of(new byte[0], new byte[] {0, 1, 0, 0, 1}, new byte[] {9, 9, 9, 9, 9, 9})) {
                odometry.publish(bytes);
                scans.publish(bytes);
            }
            advance(0.2, true);
            assertThat(robot.require(LaserScanner.class).health().isOk()).isTrue();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"/r 1", "/1r", "//", "/r1/"})
    void namespacesMustBeSome(String namespace) {
        var provider = new Ros2Provider();
        var settings = Arguments.of(provider.parameters(), Map.of("namespaces", namespace));
        assertThatThrownBy(() -> provider.create(
                        new Config(settings, Scene.of(RobotBench.WORLD.grid()), List.of(spec("r1")), 1), run))
                .isInstanceOf(InvalidRobots.class)
                .hasMessageContaining(
                        "'%s' is not a namespace of ROS 2. Write one such as /robot1.".formatted(namespace));
    }
}
