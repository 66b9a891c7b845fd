package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.testkit.OfficialPython;
import rsal.testkit.Trials;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// A simulator that a program on Cyclone DDS controls by the package `simulation_interfaces`, in each of its
/// versions.
@Timeout(value = 5, unit = TimeUnit.MINUTES)
class Ros2SimulationIT {
    /// Of `GetSpawnables_Response` in version 2, as ROS 2 publishes it.
    private static final String NEW_SPAWNABLES =
            "RIHS01_cb61fd741c429d6bc689514b7bfc65bb1518126961317acc6e414a841dc43daa";

    @TempDir
    Path folder;

    private static String script() throws IOException {
        try (var in = Objects.requireNonNull(Ros2SimulationIT.class.getResourceAsStream("/simulation_client.py"))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /// Answers in the order of the script, each after its name.
    private static List<String> answers(String printed) {
        var answers = new ArrayList<String>();
        for (String line : printed.lines().toList()) {
            JsonNode reported = JsonMapper.shared().readTree(line);
            answers.add(reported.get(0).asString() + " " + reported.get(1));
        }
        return answers;
    }

    @Trials({"1, 48", "2, 49"})
    void toolsOfRosControlTheRun(String version, int offset) throws Exception {
        String domain = Long.toString(1 + (ProcessHandle.current().pid() + offset) % 100); // no other test's
        Process robots = new Rsal(folder)
                .inEnvironment(Map.of("ROS_DOMAIN_ID", domain))
                .start("bridge", "ros2", "hunt-and-prey", "--no-agents", "--seed", "7", "--json");
        try (BufferedReader reported = robots.inputReader()) {
            assertThat(reported.readLine()).contains("/prey_1/odom");
            List<String> answers = answers(OfficialPython.run(script(), domain, version, NEW_SPAWNABLES));
            assertThat(answers)
                    .containsSubsequence(
                            "urdf [\"prey_1\",\"base_link\",true]",
                            "truth [\"map\",\"base_link\",-4.65]",
                            "health [[0,\"OK\"]]",
                            "nodes [\"/prey_1/amcl\",\"/prey_1/bt_navigator\",\"/prey_1/rsal\",\"/rsal\"]",
                            "parameters [\"use_sim_time\",\"command_timeout\",\"robot_id\",\"robot_model\","
                                    + "\"robot_role\"]",
                            "values [true,0.5,\"prey-1\",\"pioneer2dx\",\"prey\"]",
                            "amcl [3,\"active\"]",
                            "features [0,1,8,10,11,12,14,20,21,22,23,24,25,26,31,32,33]",
                            "SetSimulationState [1,\"\"]",
                            "state 2",
                            "standing 0.0",
                            "StepSimulation [1,\"\"]",
                            "stepped 0.5",
                            "accepted true",
                            "simulated [4,1]",
                            "stepped 0.8",
                            "robots [\"hunter-1\",\"hunter-2\",\"prey-1\"]",
                            "info \"A robot: Pioneer 2-DX, with the role 'prey'.\"",
                            "SetEntityState [1,\"\"]",
                            "moved 0.5",
                            "SpawnEntity [1,\"\"]",
                            "SpawnEntity [101,\"'visitor' is taken, or a robot was called so before.\"]",
                            "entities [\"hunter-1\",\"hunter-2\",\"prey-1\",\"visitor\"]",
                            "ResetSimulation [1,\"\"]",
                            "entities [\"hunter-1\",\"hunter-2\",\"prey-1\"]",
                            "ResetSimulation [1,\"\"]",
                            "early true",
                            "ResetSimulation [1,\"\"]",
                            "SetSimulationState [1,\"\"]",
                            "stopped [0,0.0]",
                            "SetSimulationState [1,\"\"]",
                            "StepSimulation [1,\"\"]",
                            "began 0.5",
                            "SetSimulationState [1,\"\"]");
            assertThat(answers).anyMatch(line -> line.startsWith("GetEntityState [2,"));
            assertThat(answers)
                    .anyMatch(line -> line.contains("[\"rsal:turtlebot3-burger\",\"A robot: TurtleBot3 Burger.\"]"));
            assertThat(robots.waitFor()).as("it quits").isEqualTo(Exit.SUCCESS);
        } finally {
            robots.destroy();
        }
    }
}
