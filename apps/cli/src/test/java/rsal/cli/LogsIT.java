package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `--log` and `rsal logs`.
class LogsIT {
    private static final String[] HUNT = {
        "run", "hunt-and-prey", "--headless", "--speed", "max", "--seed", "7", "--json"
    };
    private static final String ENTRY =
            "{\"time\":\"2026-11-29T15:00:00Z\",\"level\":\"%s\",\"part\":\"run\",\"message\":\"%s\"}\n";

    @TempDir
    private Path folder;

    private static String hash(Ended ended) {
        return JsonMapper.shared().readTree(ended.out()).path("eventHash").asString();
    }

    @Test
    void aRunIsLoggedWithoutChangingIt() throws Exception {
        var rsal = new Rsal(folder);
        Ended logged = rsal.inEnvironment(Map.of("RSAL_LOG", "run.log")).run(HUNT);
        assertThat(logged.code()).as(logged.err()).isZero();
        assertThat(hash(logged)).isEqualTo(hash(rsal.run(HUNT)));
        assertThat(logged.err()).doesNotContain("INFO");

        List<String> lines = Files.readAllLines(folder.resolve("run.log"));
        assertThat(lines).isNotEmpty().allSatisfy(line -> {
            JsonNode entry = JsonMapper.shared().readTree(line);
            assertThat(entry.path("time").asString()).endsWith("Z");
            assertThat(entry.path("run").asString()).isEqualTo("hunt-and-prey:virtual#7");
        });

        Ended all = rsal.run("logs", "run.log");
        assertThat(all.out().lines()).hasSameSizeAs(lines);
        assertThat(all.out()).contains("  escape-1: caught by hunter-2\n");
        assertThat(rsal.run("logs", "run.log", "--agent", "escape-1", "--json")
                        .out()
                        .lines())
                .isNotEmpty()
                .allSatisfy(line -> assertThat(line).contains("\"agent\":\"escape-1\",\"robot\":\"prey-1\""));
        assertThat(rsal.run("logs", "run.log", "--robot", "hunter-1").out())
                .contains("follow-1: ")
                .doesNotContain("escape-1: ");
        Ended errors = rsal.run("logs", "run.log", "--level", "error");
        assertThat(errors.out()).isEmpty();
        assertThat(errors.code()).isZero();
        assertThat(errors.err()).contains("'run.log' has no entry of level 'error' or a more important one.");
        assertThat(rsal.run("logs", "run.log", "--level", "warm").err())
                .contains("--level must be one of debug, info, warn, error, not 'warm'.");
        Ended other = rsal.run("logs", "run.log", "--run", "patrol");
        assertThat(other.out()).isEmpty();
        assertThat(other.code()).isEqualTo(3);
        Ended mistyped = rsal.run("logs", "run.log", "--robot", "hunter-9");
        assertThat(mistyped.code()).isEqualTo(3);
        assertThat(mistyped.err()).contains("No entry has the robot 'hunter-9'.", "Maybe 'hunter-1' or 'hunter-2'");
    }

    @Test
    void followingReportsWhatIsAddedAlsoToANewFile() throws Exception {
        Path log = folder.resolve("run.log");
        Files.writeString(log, ENTRY.formatted("INFO", "first") + "no JSON\n" + ENTRY.formatted("DEBUG", "second"));

        Process process = new Rsal(folder).start("logs", "run.log", "--follow", "--level", "info");
        try (BufferedReader out = process.inputReader()) {
            assertThat(out.readLine()).endsWith("  first");
            String added = ENTRY.formatted("WARN", "third");
            Files.writeString(log, added.substring(0, 20), StandardOpenOption.APPEND); // as it is written just then
            Files.writeString(log, added.substring(20), StandardOpenOption.APPEND);
            assertThat(out.readLine()).contains("WARN").endsWith("  third");
            Files.move(log, folder.resolve("run.log.1"));
            Files.writeString(log, ENTRY.formatted("ERROR", "fourth"));
            assertThat(out.readLine()).contains("ERROR").endsWith("  fourth");
        } finally {
            process.destroyForcibly().waitFor();
        }
    }

    @Test
    @LongTest
    void partsHaveLevelsOfTheirOwnAlsoOnStderr() throws Exception {
        Ended ended = new Rsal(folder)
                .run(
                        "run",
                        "patrol",
                        "--headless",
                        "--speed",
                        "max",
                        "--for",
                        "20",
                        "--log",
                        "-",
                        "--log-level",
                        "error,run=debug");
        assertThat(ended.code()).as(ended.err()).isZero();
        List<JsonNode> entries = ended.err()
                .lines()
                .filter(line -> line.startsWith("{"))
                .map(line -> JsonMapper.shared().readTree(line))
                .toList();
        assertThat(entries).extracting(entry -> entry.path("level").asString()).contains("DEBUG", "INFO");
        assertThat(entries).extracting(entry -> entry.path("part").asString()).containsOnly("run");
    }

    @Test
    void aLogInAFileRepeatsNoEventOnStderr() throws Exception {
        Path fails = Files.writeString(folder.resolve("fails.yaml"), """
                rsal: 1
                scenario: fails
                world: {map: office}
                robots:
                  guard: {model: pioneer2dx, pose: [-12, -1, 180]}
                faults: [{kind: frozen, robots: guard, devices: base, at: 1}]
                run: {stop: [{when: time > 2, outcome: success}]}
                """);
        Ended ended = new Rsal(folder).run("run", fails.toString(), "--headless", "--speed", "max", "--log", "run.log");
        assertThat(ended.code()).as(ended.err()).isZero();
        assertThat(Files.readString(folder.resolve("run.log")))
                .contains("\"robot\":\"guard\",\"device\":\"base\",\"message\":\"frozen\"");
        assertThat(ended.err().lines().filter(line -> line.contains("frozen")))
                .as(ended.err())
                .hasSize(1);
    }

    @Test
    void errorsAreReported() throws Exception {
        assertThat(new Rsal(folder).run("logs", "none.log").err()).contains("There is no such file.");
        Files.createDirectory(folder.resolve("folder"));
        Ended refused = new Rsal(folder).run("run", "--headless", "--for", "1", "--log", "folder");
        assertThat(refused.code()).isEqualTo(5);
        assertThat(refused.err()).contains("The log 'folder' can't be written");
        for (String level : List.of("loud", "info,player=loud")) {
            Ended ended = new Rsal(folder).run("run", "--headless", "--log-level", level);
            assertThat(ended.code()).isEqualTo(2);
            assertThat(ended.err()).contains("'loud' is not a level: debug, info, warn, error.");
        }
        assertThat(new Rsal(folder)
                        .run("run", "--headless", "--log-level", "Player=debug")
                        .err())
                .contains("'Player=debug' is not a level of a part, like player=debug.");
    }
}
