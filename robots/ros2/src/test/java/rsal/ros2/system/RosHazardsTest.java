package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.BumperState;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Bumper;
import rsal.device.Health;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.system.RealRobots.Waiting;
import rsal.time.LockstepScheduler;

/// The bumper of an iRobot Create 3, which is among its hazards.
class RosHazardsTest {
    private static final int BUMP = 1;
    private static final int CLIFF = 2;

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private Publication odometry;
    private Publication hazards;
    private Ros2System system;
    private Bumper bumper;

    private record Hazard(int type, String frame) {}

    @BeforeEach
    void robotIsThere() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        hazards = there.advertise(
                new RosTopic("/r1/hazard_detection", "irobot_create_msgs/msg/HazardDetectionVector"),
                Profile.SENSOR_DATA);
        system = new OneRobot(network, run).system(Map.of("bumper", "create3-bumper"));
        var found = system.discover().toCompletableFuture();
        advance(3);
        bumper = found.join().getFirst().require(Bumper.class);
    }

    @AfterEach
    void close() {
        system.close();
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            odometry.publish(messages.odometry(
                    run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            run.advance(Duration.ofMillis(50));
        }
    }

    private List<Boolean> pressed(Hazard... all) {
        CdrWriter message = RosMessages.write(new CdrWriter(), run.instant())
                .text("base_link")
                .int32(all.length);
        for (Hazard hazard : all) {
            RosMessages.write(message, run.instant()).text(hazard.frame).int8((byte) hazard.type);
        }
        hazards.publish(message.toBytes());
        advance(0.1);
        BumperState state = bumper.latest().orElseThrow().value();
        return state.pressed();
    }

    @Test
    void itsPartsAreThoseThatTheHazardsName() {
        assertThat(pressed()).containsExactly(false, false, false, false, false);
        assertThat(pressed(new Hazard(BUMP, "bump_left"))).containsExactly(true, false, false, false, false);
        assertThat(pressed(new Hazard(BUMP, "bump_front_left"))).containsExactly(false, true, false, false, false);
        assertThat(pressed(new Hazard(BUMP, "bump_front_center"), new Hazard(BUMP, "r1/bump_right")))
                .containsExactly(false, false, true, false, true);
        assertThat(pressed(new Hazard(BUMP, "bump_front_right"))).containsExactly(false, false, false, true, false);
        assertThat(pressed()).containsOnly(false);
    }

    @Test
    void otherHazardsPressNothing() {
        assertThat(pressed(new Hazard(CLIFF, "cliff_front_left"), new Hazard(BUMP, "bump_nowhere")))
                .containsOnly(false);
        hazards.publish(new byte[] {0, 1, 0, 0, 9, 9});
        advance(0.1);
        assertThat(bumper.health()).isEqualTo(Health.ok());
        hazards.close();
        advance(1);
        assertThat(bumper.health()).isInstanceOf(Health.Lost.class);
    }

    /// They may be published later than hazards.
    @Test
    void topicsThatAreSetAreNotReplacedByHazards() {
        var ours = new Ros2System(
                Map.of(OneRobot.spec(Map.of("bumper", "create3-bumper")), "/r1"),
                "domain 0",
                network::join,
                Optional.empty(),
                new RosSettings(
                        new Safety(Duration.ofMillis(500), true, "", ""),
                        GripperSettings.USUAL,
                        List.of("b0", "b1", "b2", "b3", "b4"),
                        true,
                        false),
                Waiting.USUAL,
                run,
                new SplittableRandom(1));
        var found = ours.discover().toCompletableFuture();
        advance(0.5);
        List<Publication> pads = IntStream.range(0, 5)
                .mapToObj(i -> there.advertise(new RosTopic("/r1/b" + i, "std_msgs/msg/Bool"), Profile.DEFAULT))
                .toList();
        advance(3);
        Bumper set = found.join().getFirst().require(Bumper.class);
        pads.get(3).publish(new CdrWriter().bool(true).toBytes());
        advance(0.1);
        assertThat(set.latest().orElseThrow().value().pressed()).containsExactly(false, false, false, true, false);
        ours.close();
    }
}
