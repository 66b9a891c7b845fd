package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.CloudMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.time.LockstepScheduler;

/// A robot that drives 0.5 m/s to the right of its odometry, and whose localizer is the test.
class RosLocalizerTest {
    private static final Instant ROBOT_BEGAN = Instant.ofEpochSecond(1_700_000_000);
    private static final Covariance2d SPREAD = Covariance2d.ofDeviations(0.1, 0.1, 0.1);

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private Publication odometry;
    private Publication transforms;
    private Ros2System system;
    private Localizer localizer;
    private double driven = 12; // m
    private boolean stands;
    private Duration reset = Duration.ZERO; // by which its time went back

    @BeforeEach
    void robotIsThere() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        transforms = there.advertise(new RosTopic("/r1/tf", "tf2_msgs/msg/TFMessage"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        system = new OneRobot(network, run).system(Map.of("localizer", "own-localizer"));
    }

    @AfterEach
    void close() {
        system.close();
    }

    private void find() {
        var found = system.discover().toCompletableFuture();
        advance(3);
        localizer = found.join().getFirst().require(Localizer.class);
    }

    private Instant stamp() {
        return ROBOT_BEGAN.plus(Duration.between(Instant.EPOCH, run.instant())).minus(reset);
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            odometry.publish(messages.odometry(
                    stamp(),
                    new Odometry(new Pose2d(driven, 0, 0), Twist2d.drive(0.5, 0), false),
                    "odom",
                    "base_link"));
            run.advance(Duration.ofMillis(50));
            driven += stands ? 0 : 0.025;
        }
    }

    private Publication poses() {
        return there.advertise(
                new RosTopic("/r1/amcl_pose", "geometry_msgs/msg/PoseWithCovarianceStamped"), Profile.LATCHED);
    }

    private byte[] pose(Pose2d mapFromBase) {
        var estimate = new PoseEstimate(mapFromBase, SPREAD, List.of(), 1, Quality.LOCALIZED);
        return messages.pose(stamp(), estimate, "map");
    }

    private void transform(Pose2d mapFromOdom) {
        transform(stamp(), "map", "odom", mapFromOdom);
    }

    private void transform(Instant time, String parent, String child, Pose2d pose) {
        transforms.publish(messages.transforms(List.of(new Transform(time, parent, child, FrameTransform.of(pose)))));
    }

    private double x() {
        return localizer.latest().orElseThrow().value().mapFromBase().x();
    }

    @Test
    void aPoseFromBeforeOdometryCountsFromItsBeginning() {
        run.advance(Duration.ofSeconds(60));
        poses().publish(pose(new Pose2d(2, 3, 0)));
        stands = true;
        find();
        assertThat(x()).isBetween(1.99, 2.01);
        stands = false;
        double before = driven;
        advance(2);
        assertThat(x()).isBetween(2 + driven - before - 0.1, 2 + driven - before + 0.1);
    }

    @Test
    void posesAreThoseOfTheirTime() {
        Publication poses = poses();
        find();
        byte[] then = pose(new Pose2d(7, 0, 0));
        double before = driven;
        advance(0.4); // on its way
        poses.publish(then);
        advance(0.2);
        assertThat(x()).isBetween(7 + driven - before - 0.1, 7 + driven - before + 0.1);
    }

    @Test
    void transformsThatStopComingAreStaleAndNoEstimatesFollow() {
        find();
        assertThat(localizer.health()).isInstanceOf(Health.Lost.class); // there is nothing yet
        poses(); // amcl is there all the time
        for (int i = 0; i < 10; i++) {
            transform(new Pose2d(1, 0, 0));
            advance(0.1);
        }
        assertThat(localizer.health().isOk()).isTrue();
        assertThat(x()).isBetween(driven + 0.9, driven + 1);
        advance(1);
        assertThat(localizer.health())
                .isInstanceOfSatisfying(
                        Health.Stale.class,
                        stale -> assertThat(stale.reason())
                                .isEqualTo("TF from 'map' to 'odom' has not come for more than 0.5 s."));
        Instant last = localizer.latest().orElseThrow().time();
        advance(1);
        assertThat(localizer.latest().orElseThrow().time()).isEqualTo(last);
        transform(new Pose2d(1, 0, 0));
        advance(0.1);
        assertThat(localizer.health().isOk()).isTrue();
    }

    /// Nav2's `amcl` dates its transforms one second ahead: a correction counts from then on, as all programs that use
    /// tf2 see it.
    @Test
    void correctionsCountFromTheirTimeOn() {
        find();
        for (int i = 0; i < 30; i++) {
            transform(stamp().plusSeconds(1), "map", "odom", new Pose2d(1, 0, 0));
            advance(0.1);
        }
        for (int i = 0; i < 9; i++) {
            transform(stamp().plusSeconds(1), "map", "odom", new Pose2d(3, 0, 0));
            advance(0.1);
            assertThat(x()).isBetween(driven + 0.9, driven + 1.0);
        }
        for (int i = 0; i < 5; i++) {
            transform(stamp().plusSeconds(1), "map", "odom", new Pose2d(3, 0, 0));
            advance(0.1);
        }
        assertThat(x()).isBetween(driven + 2.9, driven + 3.0);
    }

    /// A filter of several sensors, whose wheels slip: it says by TF where the robot is in `odom`, a bit later.
    @Test
    void whereTfMovesTheRobotWheelsDoNotCount() {
        find();
        poses();
        transform(stamp(), "odom", "base_link", new Pose2d(0, 7, 0));
        for (int i = 0; i < 10; i++) {
            transform(new Pose2d(1, 0, 0));
            advance(0.1);
        }
        assertThat(localizer.health())
                .isInstanceOfSatisfying(
                        Health.Stale.class,
                        stale -> assertThat(stale.reason())
                                .matches("The odometry on 'odom' waits for TF. The frame 'base_link' has transforms "
                                        + "\\(TF\\) until 17\\d+\\.\\d{3} s, but 17\\d+\\.\\d{3} s is needed."));
        for (int i = 0; i < 10; i++) {
            transform(new Pose2d(1, 0, 0));
            transform(stamp(), "odom", "base_link", new Pose2d(0, 8, 0));
            advance(0.1);
        }
        assertThat(localizer.health().isOk()).isTrue();
        assertThat(localizer.latest().orElseThrow().value().mapFromBase()).satisfies(pose -> {
            assertThat(pose.x()).isEqualTo(1);
            assertThat(pose.y()).isBetween(7.5, 8.0);
        });
    }

    @Test
    void odometryThatIsOlderThanAllTfMakesItStale() {
        find();
        for (int i = 0; i < 30; i++) {
            transform(stamp().plusSeconds(60), "map", "odom", Pose2d.ORIGIN);
            transform(stamp().plusSeconds(60), "odom", "base_link", Pose2d.ORIGIN);
            advance(0.05);
        }
        assertThat(localizer.health())
                .isInstanceOfSatisfying(
                        Health.Stale.class, stale -> assertThat(stale.reason()).contains("is older than TF"));
    }

    @Test
    void posesInAnotherFrameAreBroughtToTheMap() {
        Publication poses = poses();
        var estimate = new PoseEstimate(new Pose2d(1, 0, 0), SPREAD, List.of(), 1, Quality.LOCALIZED);
        stands = true;
        find();
        transform(stamp(), "map", "hall", new Pose2d(10, 20, Math.PI / 2));
        poses.publish(messages.pose(stamp(), estimate, "hall"));
        advance(0.2);
        assertThat(localizer.latest().orElseThrow().value().mapFromBase().distanceTo(new Pose2d(10, 21, 0)))
                .isLessThan(1e-6);
    }

    @Test
    void aSimulatorThatIsResetIsFollowedAtOnce() {
        find();
        for (int i = 0; i < 60; i++) {
            transform(new Pose2d(1, 0, 0));
            transform(stamp(), "odom", "base_link", new Pose2d(driven, 0, 0));
            advance(0.1);
        }
        reset = Duration.between(Instant.EPOCH, run.instant()).minusSeconds(1);
        driven = 0;
        for (int i = 0; i < 10; i++) {
            transform(new Pose2d(5, 0, 0));
            transform(stamp(), "odom", "base_link", new Pose2d(driven, 0, 0));
            advance(0.1);
        }
        assertThat(localizer.health().isOk()).isTrue();
        assertThat(x()).isBetween(driven + 4.8, driven + 5);
    }

    @Test
    void aLocalizerThatLeavesIsLost() {
        Publication poses = poses();
        poses.publish(pose(new Pose2d(2, 3, 0)));
        find();
        assertThat(localizer.health().isOk()).isTrue();
        poses.close();
        advance(0.2);
        assertThat(localizer.health()).isInstanceOf(Health.Lost.class);
    }

    @Test
    void odometryWithoutNumbersIsLeftOut() {
        Publication poses = poses();
        find();
        poses.publish(pose(new Pose2d(2, 3, 0)));
        odometry.publish(messages.odometry(
                stamp(), new Odometry(new Pose2d(Double.NaN, 0, 0), Twist2d.STOP, false), "odom", "base_link"));
        advance(1);
        assertThat(localizer.latest().orElseThrow().value().mapFromBase().isFinite())
                .isTrue();
    }

    private byte[] cloud(String frame, float x) {
        return CloudMessage.write(
                        new CdrWriter(), stamp(), frame, new ParticleCloud(new float[] {x, 2, 0, 3, 4, 1}, new float[] {
                            1, 3
                        }))
                .toBytes();
    }

    @Test
    void particlesComeFromTheFirstQuestionOn() {
        Publication clouds =
                there.advertise(new RosTopic("/r1/particle_cloud", "nav2_msgs/msg/ParticleCloud"), Profile.SENSOR_DATA);
        poses();
        find();
        assertThat(there.endpoints()).noneMatch(each -> each.topic().name().equals("/r1/particle_cloud"));
        assertThat(localizer.particles()).isEmpty();
        clouds.publish(cloud("odom", 1));
        clouds.publish(cloud("map", Float.NaN));
        clouds.publish(new byte[] {0, 1, 0, 0, 1, 1});
        advance(0.1);
        assertThat(localizer.particles()).isEmpty();
        clouds.publish(cloud("map", 1));
        advance(0.1);
        assertThat(localizer.particles()).hasValueSatisfying(reported -> {
            assertThat(reported.frame()).isEqualTo("map");
            assertThat(reported.value().weights()).containsExactly(0.25f, 0.75f);
            assertThat(reported.value().poses()[0]).isEqualTo(1);
        });
        clouds.close();
        assertThat(localizer.particles()).isEmpty();
    }
}
