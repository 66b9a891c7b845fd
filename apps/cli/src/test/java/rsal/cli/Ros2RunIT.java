package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Two processes, which DDS on the loopback network joins: one publishes simulated robots to ROS 2, the other one
/// drives them.
@Timeout(value = 5, unit = TimeUnit.MINUTES)
class Ros2RunIT {
    private static final int PATIENCE = 270; // s, of a run in real time

    @TempDir
    Path folder;

    /// Of a domain that no other test has.
    private Rsal rsal() {
        long domain = 1 + ProcessHandle.current().pid() % 100;
        return new Rsal(folder).inEnvironment(Map.of("ROS_DOMAIN_ID", Long.toString(domain)));
    }

    /// What the agents' process says of a run that the bridge's robots drive.
    ///
    /// @param settings of both processes
    /// @param offered names of some that the bridge offers
    /// @param more options of the run
    private JsonNode run(String scenario, List<String> settings, List<String> offered, List<String> more)
            throws Exception {
        var bridge = new ArrayList<>(List.of("bridge", "ros2", scenario, "--no-agents", "--json"));
        bridge.addAll(settings);
        Process robots = rsal().start(bridge.toArray(String[]::new));
        try (BufferedReader reported = robots.inputReader()) {
            JsonNode offers = JsonMapper.shared().readTree(reported.readLine()).get("offers");
            assertThat(offers.valueStream().map(offer -> offer.get("name").asString()))
                    .containsAll(offered);
            var command = new ArrayList<>(List.of("run", scenario + ":ros2", "--headless", "--arm", "--json"));
            command.addAll(settings);
            command.addAll(more);
            Ended run = Ended.of(rsal().start(command.toArray(String[]::new)), PATIENCE);
            assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
            return JsonMapper.shared().readTree(run.out());
        } finally {
            Ended.signal("INT", robots);
            assertThat(robots.waitFor()).isEqualTo(130);
        }
    }

    private JsonNode hunt(List<String> more) throws Exception {
        return run(
                "hunt-and-prey",
                List.of("--seed", "7"),
                List.of("/prey_1/odom", "/hunter_1/scan", "/hunter_2/cmd_vel"),
                more);
    }

    @Test
    void agentsDriveRobotsOfAnotherProcess() throws Exception {
        JsonNode result = hunt(List.of("--for", "8"));
        JsonNode end = result.get("endPoses");
        assertThat(end.size()).isEqualTo(3);
        double y = end.get("prey-1").get("y").asDouble();
        double x = end.get("prey-1").get("x").asDouble();
        assertThat(Math.hypot(x - 4, y + 1)).isBetween(0.3, 8.0); // it has driven, from where it started
    }

    @Test
    @LongTest
    void huntersCatchTheirPrey() throws Exception {
        assertThat(hunt(List.of()).get("outcome").asString()).isEqualTo("success");
    }

    /// With cameras and a gripper; the can is counted by its simulated twin in the agents' process.
    @Test
    @LongTest
    void aCollectorBringsWhatAnExplorerFinds() throws Exception {
        JsonNode result = run(
                "find-and-collect",
                List.of("--seed", "2", "--set", "cans=1", "--set", "collectors=1"),
                List.of("/collector_1/gripper_controller/gripper_cmd", "/explorer_1/camera/detections"),
                List.of());
        assertThat(result.get("outcome").asString()).isEqualTo("success");
        assertThat(result.get("metrics").get("collected").asDouble()).isEqualTo(1);
    }

    @Test
    void nobodyThereIsSaid() throws Exception {
        Ended alone = rsal().run("run", "hunt-and-prey:ros2", "--headless", "--arm");
        assertThat(alone.code()).isNotEqualTo(Exit.SUCCESS);
        assertThat(alone.err() + alone.out())
                .contains("Robot 'prey-1' was not found in the namespace '/prey_1'")
                .contains("Nothing of ROS 2 was found at all; maybe another 'domain' or 'address'?");
    }
}
