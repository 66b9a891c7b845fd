package rsal.cli.show;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.cli.Ended;
import rsal.cli.Main;
import rsal.cli.terminal.Exit;

class FileKindTest {
    @TempDir
    private Path folder;

    private record Ended(int code, String out, String err) {}

    private static Ended rsal(String... line) {
        var out = new ByteArrayOutputStream();
        var err = new StringWriter();
        var rsal = Main.commandLine(out);
        rsal.setErr(new PrintWriter(err, true));
        int code = rsal.execute(line);
        rsal.getOut().flush();
        return new Ended(code, out.toString(StandardCharsets.UTF_8), err.toString());
    }

    @BeforeEach
    void writeFiles() throws IOException {
        write("lab.yaml", """
                drawing: |
                  #####
                  #...#
                  #####
                resolution: 1
                """);
        write("bot.yaml", """
                title: My robot
                body: {radius: 0.2, height: 0.3}
                drive: {maxSpeed: 0.7, maxTurnRate: 120, maxAcceleration: 0.8, maxTurnAcceleration: 180, odometryNoise: {distancePerMeter: 0.02, headingPerMeter: 1, headingPerDegree: 0.2}}
                mounts: {laser: [0.1, 0, 0]}
                sensors: {laser: laser.yaml}
                """);
        write("laser.yaml", """
                type: laser
                fieldOfView: 270
                samples: 541
                range: [0.05, 10]
                noise: 0.01
                period: 0.1
                """);
        write("hall.yaml", "{rsal: 1, title: Hall, walls: [{radius: 0.4, center: [3, 2]}]}");
        write("guard.asl", "!guard.\n+!guard <- .print(here).\n");
        write("plan.png", "");
        Files.createDirectory(folder.resolve("office_bag"));
        write("office_bag/metadata.yaml", "rosbag2_bagfile_information:\n  version: 9\n");
        write("drive.log.gz", "");
    }

    private void write(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text);
    }

    private String file(String name) {
        return Files.exists(folder.resolve(name)) ? folder.resolve(name).toString() : name;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            lab.yaml     | This is a map, not a scenario. | world: {map: lab.yaml}
            office       | This is a map, not a scenario. | world: {map: office}
            bot.yaml     | This is a robot model, not a scenario. | {model: bot.yaml}
            pioneer2dx   | This is a robot model, not a scenario. | {model: pioneer2dx}
            laser.yaml   | This is a part of robots, not a scenario. | {DEVICE: laser.yaml}
            hall.yaml    | This is a world, not a scenario. | end with .world.yaml
            guard.asl    | This is an agent's program, not a scenario. | {type: guard.asl}
            run.mcap     | This is a recording, not a scenario. | plays it
            plan.png     | This is an image, not a scenario. | A map is a YAML file
            drive.log.gz | This is a log of a robot, not a scenario. | makes a map of it
            office_bag   | This is a bag of ROS 2, not a scenario. | --map MAP.yaml' localizes the robot
            """)
    void whereAScenarioIsAskedForOtherFilesAreCalledWhatTheyAre(String name, String message, String remedy) {
        String file = file(name);
        for (String[] line : new String[][] {
            {"run", file, "--headless"},
            {"sweep", file, "--out", folder.resolve("out").toString()},
            {"bridge", "player", file}
        }) {
            Ended refused = rsal(line);
            assertThat(refused.code()).as("%s", (Object) line).isEqualTo(Exit.INVALID);
            assertThat(refused.err()).startsWith(file + ": " + message).contains(remedy);
            assertThat(refused.out()).isEmpty();
        }
        assertThat(folder.resolve("out")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            lab.yaml   | valid, a map, 5.0 × 3.0 m, 5 × 3 cells of 1.0 m
            office     | valid, a map, 63.0 × 15.6 m, 1259 × 312 cells of 0.05 m
            bot.yaml   | valid, a robot model, My robot
            laser.yaml | valid, a part of robots, a LaserScanner
            guard.asl  | valid, an agent's program
            """)
    void whatIsNoScenarioIsCheckedToo(String name, String words) {
        Ended checked = rsal("validate", file(name));
        assertThat(checked.out()).isEqualTo(file(name) + ": " + words + "\n");
        assertThat(checked.code()).isEqualTo(Exit.SUCCESS);
        assertThat(rsal("validate", file(name), "--json").out()).contains("\"valid\":true");
    }

    @ParameterizedTest
    @ValueSource(strings = {"plan.png", "drive.log.gz", "hall.yaml", "missing.mcap"})
    void whatCanNotBeCheckedIsNotValid(String name) {
        assertThat(rsal("validate", file(name)).code()).isEqualTo(Exit.INVALID);
    }

    @Test
    void whatIsWrongInAModelOrItsPartsIsWhereThePersonKnowsIt() throws IOException {
        write("laser.yaml", "type: laser\nfieldOfView: 270\nsamples: 541\nrange: [0.05, 10]\nnoise: -1\nperiod: 0.1\n");
        for (String name : new String[] {"bot.yaml", "laser.yaml"}) {
            Ended wrong = rsal("validate", file(name));
            assertThat(wrong.code()).isEqualTo(Exit.INVALID);
            assertThat(wrong.out())
                    .contains(folder.resolve("laser.yaml") + ":5:8: ")
                    .doesNotContain("scenario");
        }
    }

    @Test
    void aMapIsDrawnAndAModelShown() {
        Path image = folder.resolve("lab.png");
        assertThat(rsal("show", file("lab.yaml"), "--image", image.toString()).out())
                .contains("5 × 3 cells of 1.0 m", "Drawn to " + image);
        assertThat(image).isNotEmptyFile();
        assertThat(rsal("show", file("bot.yaml")).out()).contains("a robot model, My robot", "maxTurnRate: 120");
        assertThat(rsal("show", file("laser.yaml")).out()).contains("a robot part, a LaserScanner");
    }

    @ParameterizedTest
    @CsvSource({
        "controller, Cautious.java, a controller for 'navigator', room",
        "metric, Spacing.java, a metric, mean(spacing)",
    })
    void whatAFileAddsToRobotsAndMetricsIsCalledWhatItIs(String kind, String file, String title, String content)
            throws IOException {
        Path made = folder.resolve("own");
        assertThat(rsal("new", made.toString(), "--kind", kind).code()).isEqualTo(Exit.SUCCESS);
        String name = made.resolve(file).toString();
        assertThat(rsal("show", name).out())
                .startsWith(file + ": " + title + "\n")
                .contains(content);
        assertThat(rsal("validate", name).out()).isEqualTo(name + ": valid, " + title + "\n");
        assertThat(rsal("run", name, "--headless").err())
                .startsWith(name + ": This is a metric or a plugin, not a scenario.");
        Files.writeString(made.resolve(file), "public class %s {".formatted(file.replace(".java", "")));
        assertThat(rsal("validate", name).out()).contains("Java can't compile this", file + ":1:");
        assertThat(rsal("validate", name).code()).isEqualTo(Exit.INVALID);
    }
}
