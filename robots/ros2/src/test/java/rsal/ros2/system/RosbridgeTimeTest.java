package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.rosbridge.FakeRosbridge;
import rsal.ros2.rosbridge.RosbridgeLink;
import rsal.ros2.rosbridge.RosbridgeOptions;
import rsal.ros2.rosbridge.RosbridgeOptions.Encoding;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.system.RealRobots.Waiting;
import rsal.time.LockstepScheduler;

/// A simulator whose time comes through a server of rosbridge.
class RosbridgeTimeTest {
    private static final Duration STEP = Duration.ofMillis(50);
    private static final RosbridgeOptions OPTIONS =
            new RosbridgeOptions(URI.create("ws://robot.local:9090"), Encoding.CBOR, Duration.ZERO, Optional.empty());

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final FakeRosbridge server = new FakeRosbridge(network, false);
    private final RosMessages messages = new RosMessages();
    private Publication odometry;
    private Publication clock;
    private Ros2System system;
    private Instant simulated = Instant.ofEpochSecond(100);

    @BeforeEach
    void aRobotIsFound() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        clock = there.advertise(new RosTopic("/clock", "rosgraph_msgs/msg/Clock"), Profile.SENSOR_DATA);
        system = new Ros2System(
                Map.of(OneRobot.spec(Map.of()), "/r1"),
                "rosbridge",
                () -> new RosbridgeLink(server.transport(), OPTIONS, run),
                Optional.empty(),
                new RosSettings(
                        new Safety(Duration.ofMillis(500), true, "", ""), GripperSettings.USUAL, List.of(), true, true),
                Waiting.USUAL,
                run,
                new SplittableRandom(1));
        var found = system.discover().toCompletableFuture();
        advance(6);
        assertThat(found).isCompleted();
    }

    @AfterEach
    void close() {
        system.close();
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            simulated = simulated.plus(STEP);
            clock.publish(messages.clock(simulated));
            odometry.publish(messages.odometry(
                    simulated, new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            run.advance(STEP);
        }
    }

    @Test
    void aTimeThatComesIsPublishedWhateverRosapiSays() {
        server.refuse(Set.of("node_details"));
        advance(30);
        clock.close();
        clock = there.advertise(new RosTopic("/other_clock", "rosgraph_msgs/msg/Clock"), Profile.SENSOR_DATA);
        assertThatThrownBy(() -> advance(10))
                .hasMessageStartingWith("The run can't go on without time. Nobody publishes '/clock'");
    }

    @Test
    void aConnectionThatIsLostDoesNotEndTheRun() {
        server.down();
        advance(60);
        server.up();
        advance(15);
        clock.close();
        clock = there.advertise(new RosTopic("/other_clock", "rosgraph_msgs/msg/Clock"), Profile.SENSOR_DATA);
        assertThatThrownBy(() -> advance(15))
                .hasMessageStartingWith("The run can't go on without time. Nobody publishes '/clock'");
    }
}
