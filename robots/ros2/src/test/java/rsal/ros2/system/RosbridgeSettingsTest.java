package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.rosbridge.FakeRosbridge;
import rsal.ros2.rosbridge.RosbridgeLink;
import rsal.ros2.rosbridge.RosbridgeOptions;
import rsal.ros2.rosbridge.RosbridgeOptions.Encoding;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.ros2.type.Distribution;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.system.RealRobots.Waiting;
import rsal.system.RobotSystemProvider.Config;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.testkit.contract.RobotBench;
import rsal.time.LockstepScheduler;

/// What is said of servers of rosbridge in scenarios, and when they are not there.
class RosbridgeSettingsTest {
    private final LockstepScheduler run = new LockstepScheduler();
    private final Ros2Provider provider = new Ros2Provider();

    private Arguments settings(Map<String, String> given) {
        var all = new HashMap<>(Map.of("rosbridge", "ws://robot.local"));
        all.putAll(given);
        return Arguments.parse(provider.parameters(), all);
    }

    @Test
    void haveDefaults() {
        assertThat(Ros2Provider.rosbridge(settings(Map.of())))
                .isEqualTo(new RosbridgeOptions(
                        URI.create("ws://robot.local:9090"), Encoding.CBOR, Duration.ZERO, Optional.empty()));
    }

    @Test
    void canBeSet() {
        assertThat(Ros2Provider.rosbridge(settings(Map.of(
                        "rosbridge", "wss://10.0.0.7:443/bridge",
                        "rosbridgeEncoding", "json",
                        "rosbridgeRate", "5",
                        "distribution", "humble"))))
                .isEqualTo(new RosbridgeOptions(
                        URI.create("wss://10.0.0.7:443/bridge"),
                        Encoding.JSON,
                        Duration.ofMillis(200),
                        Optional.of(Distribution.HUMBLE)));
    }

    @ParameterizedTest
    @CsvSource({
        "rosbridge, http://robot.local, 'http://robot.local'",
        "domain, 5, 'domain'",
        "address, 127.0.0.1, 'address'",
        "peers, 127.0.0.1, 'peers'"
    })
    void areRefusedWhereTheyCannotBe(String name, String value, String part) {
        var config = new Config(
                settings(Map.of(name, value)), Scene.of(RobotBench.WORLD.grid()), List.of(OneRobot.spec(Map.of())), 1);
        assertThatThrownBy(() -> provider.create(config, run))
                .isInstanceOf(InvalidRobots.class)
                .hasMessageContaining(part);
    }

    @Test
    void aServerThatIsNotThereIsNamed() {
        var rosbridge = new FakeRosbridge(new MemoryNetwork(), false);
        rosbridge.down();
        assertThatThrownBy(() -> find(rosbridge))
                .hasMessageContaining("rosbridge at 'ws://robot.local:9090' can't be reached: nobody listens there")
                .hasMessageContaining("Is rosbridge_server running there?");
    }

    /// And DDS is not blamed.
    @Test
    void aServerWithoutARobotIsNamed() {
        assertThatThrownBy(() -> find(new FakeRosbridge(new MemoryNetwork(), false)))
                .hasMessageContaining(
                        "Nothing of ROS 2 was found at all; do the robot's drivers run beside rosbridge?");
    }

    private void find(FakeRosbridge rosbridge) {
        RosbridgeOptions options = Ros2Provider.rosbridge(settings(Map.of()));
        var system = new Ros2System(
                Map.of(OneRobot.spec(Map.of()), "/r1"),
                "rosbridge",
                () -> new RosbridgeLink(rosbridge.transport(), options, run),
                Optional.empty(),
                new RosSettings(
                        new Safety(Duration.ofMillis(500), true, "", ""),
                        GripperSettings.USUAL,
                        List.of(),
                        true,
                        false),
                Waiting.USUAL,
                run,
                new SplittableRandom(1));
        CompletableFuture<List<Robot>> found = system.discover().toCompletableFuture();
        for (int i = 0; i < 400 && !found.isDone(); i++) {
            run.advance(Duration.ofMillis(50));
        }
        system.close();
        found.join();
    }
}
