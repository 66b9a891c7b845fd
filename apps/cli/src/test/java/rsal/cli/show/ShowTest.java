package rsal.cli.show;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.cli.Main;
import rsal.cli.terminal.Exit;

class ShowTest {
    private static String show(String... line) {
        var out = new ByteArrayOutputStream();
        var rsal = Main.commandLine(out);
        assertThat(rsal.execute(line)).isEqualTo(Exit.SUCCESS);
        rsal.getOut().flush();
        return out.toString(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"patrol", "rescue"})
    void aScenarioComesBeforeAnAgentOfItsName(String name) {
        assertThat(show("show", name))
                .contains("Configurations", "Metrics")
                .endsWith("\n'%s' is also a type of agents: rsal show agent:%s\n".formatted(name, name));
        assertThat(show("show", "agent:" + name))
                .startsWith(name + ": a type of agents\n")
                .doesNotContain("Metrics");
        assertThat(show("show", name, "--json")).startsWith("{\"scenario\":\"%s\"".formatted(name));
    }

    @Test
    void robotsOfOneRoleMayDiffer(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("two.yaml"), """
                rsal: 1
                scenario: two
                world: {map: office}
                robots:
                  rover:
                    model: pioneer2dx
                    mrs: {sensorNoise: 0}
                    members:
                      - {name: ann, pose: [-12, -1, 0]}
                      - {name: bea, pose: [-8, -1, 0], model: pioneer3at}
                """);
        assertThat(show("show", file.toString()))
                .containsPattern("rover +1 × pioneer2dx")
                .containsPattern("rover +1 × pioneer3at")
                .containsPattern("mrs: sim, sensorNoise=0.0 +ann\n")
                .containsPattern("mrs: sim, sensorNoise=0.0 +bea\n");
        assertThat(show("show", file.toString(), "--json"))
                .contains(
                        "\"ids\":[\"bea\"],\"mrs\":\"sim, sensorNoise=0.0\",\"proxy\":false,\"overlay\":false,\"model\":\"pioneer3at\"");
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            image: lab.pgm, origin: [0, 0, 0]          | 'resolution' is missing: a number.
            resolution: 0.05, origin: [0, 0, 0]        | 'image' is missing: a text.
            resolution: 0.05, negate: 0                | 'image' is missing: a text.
            """)
    void ofAMapInWhichSomethingIsMissingItSaysWhat(String text, String missing, @TempDir Path folder)
            throws IOException {
        Path file = Files.writeString(folder.resolve("lab.yaml"), "{%s}".formatted(text));
        var err = new StringWriter();
        var rsal = Main.commandLine(new ByteArrayOutputStream());
        rsal.setErr(new PrintWriter(err));
        assertThat(rsal.execute("show", file.toString())).isEqualTo(Exit.INVALID);
        assertThat(err.toString()).contains(missing).doesNotContain("scenario");
    }
}
