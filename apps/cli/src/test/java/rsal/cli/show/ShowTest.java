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

    private static String refused(String... line) {
        var err = new StringWriter();
        var rsal = Main.commandLine(new ByteArrayOutputStream());
        rsal.setErr(new PrintWriter(err));
        assertThat(rsal.execute(line)).isEqualTo(Exit.USAGE);
        return err.toString();
    }

    /// A hall of 4 m × 3 m.
    ///
    /// @param more lines of the map's YAML
    private static Path hall(Path folder, String more) throws IOException {
        var rows = new StringBuilder("P2\n40 30\n255\n");
        for (int row = 0; row < 30; row++) {
            for (int column = 0; column < 40; column++) {
                boolean wall = row == 0 || row == 29 || column == 0 || column == 39;
                rows.append(wall ? "0 " : "254 ");
            }
            rows.append('\n');
        }
        Files.writeString(folder.resolve("hall.pgm"), rows);
        return Files.writeString(folder.resolve("hall.yaml"), """
                image: hall.pgm
                resolution: 0.1
                origin: [0, 0, 0]
                negate: 0
                occupied_thresh: 0.65
                free_thresh: 0.196
                """ + more);
    }

    @Test
    void onePlaceIsNotApartFromAnother(@TempDir Path folder) throws IOException {
        String image = folder.resolve("hall.png").toString();
        String map = hall(folder, "").toString();
        assertThat(show("show", map, "--rooms", "--places", "1", "--image", image))
                .contains("Places for 1 robot\n")
                .containsPattern("apart +1 +0 +- +[0-9.]+ m")
                .doesNotContain("Infinity");
        assertThat(show("show", map, "--rooms", "--places", "1", "--image", image, "--json"))
                .contains("\"objective\":\"apart\"", "\"greatest\":")
                .doesNotContain("Infinity", "\"least\":\"");
        assertThat(show("show", map, "--rooms", "--places", "2", "--image", image, "--json"))
                .containsPattern("\"least\":[0-9.]+");
    }

    @Test
    void placesWithoutRoomsAndForTooManyRobotsAreRefused() {
        assertThat(refused("show", "office", "--places", "5")).contains("'5'", "--rooms");
        assertThat(refused("show", "office", "--rooms", "--places", "200"))
                .contains("'200'", "1 to 128")
                .doesNotContain("evenly");
        assertThat(refused("show", "office", "--rooms", "--places", "0")).contains("'0'");
    }

    @Test
    void roomsOfAMapComeWithTheWarningsOfItsFile(@TempDir Path folder) throws IOException {
        String map = hall(folder, "colour: blue\n").toString();
        String image = folder.resolve("hall.png").toString();
        assertThat(show("show", map, "--image", image)).contains("colour");
        assertThat(show("show", map, "--rooms", "--image", image)).contains("1 room", "colour");
        assertThat(show("show", map, "--rooms", "--image", image, "--json"))
                .contains("\"warnings\":[{")
                .contains("colour");
    }
}
