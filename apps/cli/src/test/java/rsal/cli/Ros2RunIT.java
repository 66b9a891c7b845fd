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
    @TempDir
    Path folder;

    /// Of a domain that no other test has.
    private Rsal rsal() {
        long domain = 1 + ProcessHandle.current().pid() % 100;
        return new Rsal(folder).inEnvironment(Map.of("ROS_DOMAIN_ID", Long.toString(domain)));
    }

    /// What the agents' process says, of a hunt for so many seconds.
    private JsonNode hunt(List<String> more) throws Exception {
        Process robots = rsal().start("bridge", "ros2", "hunt-and-prey", "--no-agents", "--seed", "7", "--json");
        try (BufferedReader told = robots.inputReader()) {
            JsonNode offers = JsonMapper.shared().readTree(told.readLine()).get("offers");
            assertThat(offers.valueStream().map(offer -> offer.get("name").asString()))
                    .contains("/prey_1/odom", "/hunter_1/scan", "/hunter_2/cmd_vel");
            var command = new ArrayList<>(
                    List.of("run", "hunt-and-prey:ros2", "--seed", "7", "--headless", "--arm", "--json"));
            command.addAll(more);
            Ended hunt = rsal().run(command.toArray(String[]::new));
            assertThat(hunt.code()).as(hunt.err()).isEqualTo(Exit.SUCCESS);
            return JsonMapper.shared().readTree(hunt.out());
        } finally {
            Ended.signal("INT", robots);
            assertThat(robots.waitFor()).isEqualTo(130);
        }
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

    @Test
    void nobodyThereIsSaid() throws Exception {
        Ended alone = rsal().run("run", "hunt-and-prey:ros2", "--headless", "--arm");
        assertThat(alone.code()).isNotEqualTo(Exit.SUCCESS);
        assertThat(alone.err() + alone.out())
                .contains("Robot 'prey-1' was not found in the namespace '/prey_1'")
                .contains("Nothing of ROS 2 was found at all; maybe another 'domain' or 'address'?");
    }
}
