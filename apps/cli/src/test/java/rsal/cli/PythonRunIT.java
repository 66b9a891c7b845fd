package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;
import rsal.testkit.OfficialPython;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Hunters in Python, prey in AgentSpeak and a watcher in Java, in one run.
class PythonRunIT {
    @TempDir
    Path folder;

    @Test
    @LongTest
    void agentsInThreeLanguagesRunTogetherAndEqualSeedsGiveEqualRuns() throws Exception {
        var rsal = new Rsal(folder)
                .inEnvironment(
                        Map.of("RSAL_PYTHON", OfficialPython.interpreter().toString()));
        assertThat(rsal.run("new", "mine", "--from", "hunt-and-prey").code()).isEqualTo(Exit.SUCCESS);
        Path scenario = folder.resolve("mine/mine.yaml");
        String text = Files.readString(scenario);
        Files.writeString(scenario, text + """
                  three:
                    agents:
                      watcher: {type: Watcher.java}
                      escape: {type: prey.asl, robot: prey, parameters: {hunter: hunter}}
                      follow: {type: hunter.py, robot: hunter, parameters: {prey: prey}}
                """);
        JsonNode first = result(rsal, "7");
        assertThat(first.get("outcome").stringValue()).isEqualTo("success");
        assertThat(first.get("failed").isEmpty()).isTrue();
        assertThat(first.get("metrics").get("captureTime").doubleValue()).isBetween(5.0, 120.0);
        assertThat(result(rsal, "7").get("eventHash")).isEqualTo(first.get("eventHash"));
    }

    private static JsonNode result(Rsal rsal, String seed) throws Exception {
        Ended ended = rsal.run("run", "mine/mine.yaml:three", "--headless", "--speed", "max", "--seed", seed, "--json");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        return JsonMapper.shared().readTree(ended.out());
    }
}
