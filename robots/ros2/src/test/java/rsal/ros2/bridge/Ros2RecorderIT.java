package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.Twist2d;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.CommandTimeout;
import rsal.system.RobotRecorder;
import rsal.system.RobotSystemProvider;
import rsal.testkit.OfficialBagReader;
import rsal.testkit.contract.RobotBench;

/// What is recorded of a simulated robot is read by rosbags and by MCAP's package.
class Ros2RecorderIT extends RobotBench {
    @TempDir
    private Path folder;

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("battery", "pioneer-battery");
    }

    @Test
    void othersReadAllThatItSenses() throws Exception {
        Path bag = folder.resolve("bag");
        RobotRecorder recorder = new Ros2RecorderProvider().begin(bag, false, "a test");
        var context =
                new BridgeContext(List.of(robot()), WORLD.grid(), Optional.empty(), List.of(), CommandTimeout.none());
        Bridge bridge = recorder.open(context, run);
        drive(Twist2d.drive(0.3, 0.2), 3);
        bridge.close();
        recorder.close();
        assertThat(recorder.failure()).isEmpty();
        List<String> topics = OfficialBagReader.topics(bag);
        assertThat(topics)
                .contains("/map nav_msgs/msg/OccupancyGrid 1 TRANSIENT_LOCAL")
                .anySatisfy(topic -> assertThat(topic).startsWith("/r1/battery_state sensor_msgs/msg/BatteryState"))
                .anySatisfy(topic -> assertThat(topic).startsWith("/r1/scan sensor_msgs/msg/LaserScan"))
                .anySatisfy(topic -> assertThat(topic).startsWith("/r1/sonar_7 sensor_msgs/msg/Range"))
                .anySatisfy(topic -> assertThat(topic).startsWith("/clock rosgraph_msgs/msg/Clock"));
        assertThat(OfficialBagReader.first(bag, "/r1/scan")).contains("frame_id='r1/laser'");
        assertThat(OfficialBagReader.first(bag, "/r1/odom"))
                .contains("frame_id='r1/odom'", "child_frame_id='r1/base_link'");
    }
}
