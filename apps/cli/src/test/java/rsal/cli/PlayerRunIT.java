package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Agents in one process, robots in another, as with real ones: nothing is shared but sockets.
@Timeout(value = 5, unit = TimeUnit.MINUTES)
class PlayerRunIT {
    @TempDir
    Path folder;

    /// Serves a scenario's robots, which nobody drives there.
    private Process serve(List<String> arguments) throws Exception {
        var all = new ArrayList<>(List.of("bridge", "player"));
        all.addAll(arguments);
        all.addAll(List.of("--no-agents", "--port", "0", "--json"));
        return new Rsal(folder).start(all.toArray(String[]::new));
    }

    /// Of the first ones.
    private static String servers(BufferedReader told, int robots) throws Exception {
        Set<String> ports = new LinkedHashSet<>();
        JsonNode json = JsonMapper.shared().readTree(told.readLine());
        json.get("offers")
                .forEach(offer -> ports.add("localhost:" + offer.get("port").asInt()));
        return String.join(",", List.copyOf(ports).subList(0, robots));
    }

    /// Of three robots all are real, or two, while the third is simulated.
    @ParameterizedTest
    @CsvSource({"real, 3", "mixed, 2"})
    void huntersOnPlayerServersCatchTheirPrey(String configuration, int real) throws Exception {
        Process robots = serve(List.of("hunt-and-prey", "--seed", "7"));
        try (BufferedReader told = robots.inputReader()) {
            String servers = servers(told, real);
            Process agents = new Rsal(folder)
                    .start(
                            "run",
                            "hunt-and-prey:" + configuration,
                            "--seed",
                            "7",
                            "--set",
                            "servers=" + servers,
                            "--headless",
                            "--arm",
                            "--json");
            JsonNode result;
            try (BufferedReader out = agents.inputReader()) {
                result = JsonMapper.shared().readTree(out.readLine());
            }
            assertThat(agents.waitFor()).isZero();
            assertThat(result.get("outcome").asString()).isEqualTo("success");
            assertThat(result.get("measures").get("captureTime").asDouble()).isBetween(5.0, 290.0);
        } finally {
            Ended.signal("INT", robots);
            assertThat(robots.waitFor()).isEqualTo(130);
        }
    }
}
