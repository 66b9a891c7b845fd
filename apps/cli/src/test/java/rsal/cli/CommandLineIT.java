package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileError;
import rsal.map.Maps;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// The whole command: exit codes, what is on stdout and stderr, signals. Most commands are done by one process, as a
/// start takes most of their time. Those of `headless`, signals, environment and flags have processes of their own.
class CommandLineIT {
    private static final String GUARD = """
            rsal: 1
            scenario: guard
            title: A robot stands and waits
            arguments:
              guards: {type: integer, default: 1, min: 1, max: 4, description: How many robots stand.}
            world: {map: office}
            robots:
              guard: {count: $guards, model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx}}
            run:
              seed: 3
              stop:
                - {when: time > 20, outcome: success}
            metrics:
              - {name: collisions, from: count(collisions), better: less, bound: {max: 0}}
              - {name: firstCollision, unit: s, from: firstTime(collisions > 0)}
            configurations:
              long: {title: Twenty seconds}
              short: {run: {stop: [{when: time > 5, outcome: success}]}}
              late: {run: {stop: [{when: time > 5, outcome: timeout}]}}
            """;

    private static final String EXPLORE = """
            rsal: 1
            scenario: explore
            world: {map: office}
            robots:
              scout:
                model: pioneer2dx
                pose: [-12, -0.8, 0]
                devices: {laser: urg04lx, localizer: {type: slam}, navigator: {}, explorer: {}}
            run: {stop: [{when: time > 8, outcome: success}]}
            """;

    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    Path folder;

    private Rsal rsal;

    @BeforeEach
    void writeScenario() throws IOException {
        Files.writeString(folder.resolve("guard.yaml"), GUARD);
        rsal = new Rsal(folder);
    }

    @Test
    void helpGoesToStdout() throws Exception {
        Ended ended = rsal.apart().run("--help");
        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out()).contains("run", "list", "show", "validate", "convert", "doctor", "test", "Exit codes");
        assertThat(ended.err()).isEmpty();
    }

    @Test
    void theMapsThatRobotsDrewAreSaved() throws Exception {
        Files.writeString(folder.resolve("explore.yaml"), EXPLORE);
        String[] line = {"run", "explore.yaml", "--headless", "--speed", "max", "--save-maps", "maps"};

        Ended ended = rsal.run(line);
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.err()).contains("Map saved: maps/scout.yaml");
        var map = new Maps(FileSource.disk())
                .read(folder.resolve("maps/scout.yaml").toString(), Location.of("test"));
        assertThat(map.isFree(-12, -0.8)).isTrue();

        Ended again = rsal.run(line);
        assertThat(again.code()).isEqualTo(Exit.INVALID);
        assertThat(again.err()).contains("scout.yaml", "--force");
        Ended none = rsal.run("run", "guard.yaml", "--headless", "--save-maps", "others");
        assertThat(none.code()).isEqualTo(Exit.INVALID);
        assertThat(none.err()).contains("--save-maps", "No robot of this run draws a map");
        assertThat(folder.resolve("others")).doesNotExist();
    }

    /// Simulated motors are on anyway; that they were switched on is an event, which recordings have.
    @Test
    @LongTest
    void armingAndSavingMapsHoldForTheScenarioThatWasTyped() throws Exception {
        Files.writeString(folder.resolve("explore.yaml"), EXPLORE);
        String[] line = {"--port", "0", "--speed", "2", "--arm", "--save-maps", "maps", "--record", "run.mcap"};
        Process process = rsal.withPage()
                .start(Stream.concat(Stream.of("run", "explore.yaml"), Stream.of(line))
                        .toArray(String[]::new));
        try {
            BufferedReader err = process.errorReader();
            URI page = URI.create(err.readLine().substring("Watch it at ".length()));
            assertThat(untilARunHasEnded(err)).contains("Map saved: maps/scout.yaml");
            choose(page, "{\"scenario\":\"hunt-and-prey\",\"seed\":\"7\",\"speed\":\"max\"}");
            assertThat(untilARunHasEnded(err)).noneMatch(said -> said.contains("map") || said.contains("Map"));
            choose(page, "{\"scenario\":\"explore.yaml\",\"speed\":\"2\"}"); // again
            assertThat(untilARunHasEnded(err)).contains("Map saved: maps/scout.yaml");
            String edited = new JsonMapper().writeValueAsString(EXPLORE + "# edited\n");
            choose(page, "{\"scenario\":\"explore.yaml\",\"speed\":\"2\",\"text\":" + edited + "}");
            assertThat(untilARunHasEnded(err)).contains("Map saved: maps/scout.yaml");
        } finally {
            Ended.signal("INT", process);
            Ended.of(process);
        }
        assertThat(operatorsEvents("run.mcap")).containsExactly("motors on");
        assertThat(operatorsEvents("run-2.mcap")).isEmpty();
        assertThat(operatorsEvents("run-3.mcap")).containsExactly("motors on");
        assertThat(operatorsEvents("run-4.mcap")).as("nobody typed that text").isEmpty();
    }

    private static void choose(URI page, String wish) throws Exception {
        HttpRequest another = HttpRequest.newBuilder(page.resolve("/api/run/restart"))
                .header("Authorization", "Bearer " + page.getFragment().substring("token=".length()))
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofString(wish))
                .build();
        try (var client = HttpClient.newHttpClient()) {
            HttpResponse<String> answer = client.send(another, BodyHandlers.ofString());
            assertThat(answer.statusCode()).as(answer.body()).isEqualTo(200);
        }
    }

    private static List<String> untilARunHasEnded(BufferedReader err) throws IOException {
        var said = new ArrayList<String>();
        String line;
        while ((line = err.readLine()) != null && !line.startsWith("The page is still there")) {
            said.add(line);
        }
        assertThat(line).as("%s", said).isNotNull();
        return said;
    }

    private List<String> operatorsEvents(String recording) throws Exception {
        Ended ended = rsal.run("export", recording, "--csv", recording + "-tables");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        return Files.readAllLines(folder.resolve(recording + "-tables/events.csv")).stream()
                .map(row -> row.split(",", -1))
                .filter(row -> row[3].equals("operator"))
                .map(row -> row[5])
                .toList();
    }

    @Test
    void validateNotesWhatMayNotBeMeant() throws Exception {
        Files.writeString(folder.resolve("open.yaml"), "drawing: |\n  ####\n  #...\n  ####\nresolution: 1\n");
        Files.writeString(folder.resolve("lost.yaml"), """
                rsal: 1
                scenario: lost
                world: {map: open.yaml}
                robots:
                  scout:
                    model: pioneer2dx
                    devices: {laser: urg04lx, localizer: {type: slam}, navigator: {}, explorer: {}}
                run: {stop: [{when: time > 1, outcome: success}]}
                """);
        Ended ended = rsal.run("validate", "lost.yaml");
        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out())
                .contains("Robot 'scout' has no 'pose'", "a frame of its own")
                .contains("open at its edge, at (3.5, 1.5)");
        assertThat(rsal.run("validate", "guard.yaml").out()).doesNotContain("Note");
        assertThat(rsal.run("run", "lost.yaml", "--headless").err()).contains("Note: The map is open at its edge");
    }

    @Test
    void notesPlacesThatNoRobotGetsTo() throws Exception {
        Files.writeString(folder.resolve("watch.yaml"), """
                rsal: 1
                scenario: watch
                arguments: {places: {type: string, default: "0 -1; 900 0"}}
                world: {map: office}
                robots: {guard: {model: pioneer3at, pose: [0, -1, 0], devices: {laser: utm30lx, localizer: amcl, planner: wavefront, navigator: {}}}}
                agents: {worker: {type: worker, robot: guard}, patrol: {type: patrol, parameters: {places: $places}}}
                run: {stop: [{when: time > 1, outcome: success}]}
                """);
        Ended ended = rsal.run("validate", "watch.yaml");
        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out())
                .contains("Note: watch.yaml:3:", "'places' of agent 'patrol'", "(900.00, 0.00) is outside the map");
        assertThat(rsal.run("run", "watch.yaml", "--headless", "--set", "places=800 0")
                        .err())
                .contains("Note: --set places=800 0: 'places' of agent 'patrol'");
        assertThat(rsal.run("run", "watch.yaml", "--headless", "--set", "places=0 -1")
                        .err())
                .doesNotContain("Note");
    }

    @Test
    void showsMapsModelsAndParts() throws Exception {
        assertThat(rsal.run("show", "office").out()).contains("a map, 63.", "world: {map: office}");
        assertThat(rsal.run("show", "pioneer2dx").out()).contains("a robot model, Pioneer 2-DX", "mounts:");
        assertThat(rsal.run("show", "urg04lx").out()).contains("a robot part, Hokuyo URG-04LX", "fieldOfView: 240");
        assertThat(rsal.run("list", "parts").out()).containsPattern("urg04lx +Hokuyo URG-04LX");
        assertThat(rsal.run("list", "models").out()).containsPattern("pioneer2dx +Pioneer 2-DX");
        assertThat(rsal.run("list", "maps").out()).containsPattern("office +63");
        Files.writeString(folder.resolve("mine.yaml"), "drawing: |\n  ####\n  #..#\n  ####\nresolution: 0.5\n");
        assertThat(rsal.run("show", "mine.yaml").out()).contains("4 × 3 cells", "world: {map: mine.yaml}");
        assertThat(rsal.run("show", "urg05lx").err()).contains("Maybe 'urg04lx'");
        assertThat(rsal.run("show", "nd").out())
                .contains("a controller for 'navigator'", "avoidDist", "controller: {type: nd, …}")
                .doesNotContain("minGapWidth", "weightDesiredDir");
        assertThat(rsal.run("list", "controllers").out()).containsPattern("dwa +Chooses");
    }

    @Test
    void helpIsACommand() throws Exception {
        Ended ended = rsal.run("help");
        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out()).isEqualTo(rsal.run("--help").out());
        assertThat(rsal.run("help", "map").out()).contains("Usage: rsal map");
    }

    @Test
    void aBenchWithoutItsDataIsNoSuccess() throws Exception {
        Ended nowhere = rsal.run("bench", "navigation", "--only", "barn.vfh", "--data", "nowhere");
        assertThat(nowhere.code()).isEqualTo(Exit.INVALID);
        assertThat(nowhere.err()).contains("--data", "There is no folder 'nowhere'");

        Ended empty = rsal.run("bench", "navigation", "--only", "barn.vfh", "--data", folder.toString());
        assertThat(empty.code()).isEqualTo(Exit.UNREACHABLE);
        assertThat(empty.err()).contains("barn/worlds.json", "Nothing was measured");
        assertThat(empty.out()).isEmpty();
    }

    @Test
    @LongTest
    void theSameProgramsInAgentSpeakAreMeasuredOnJasonWithUsAndWithout() throws Exception {
        Ended ended = rsal.run("bench", "mas", "--only", "jason.written.create.100", "--repeat", "1", "--json");
        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out())
                .contains("\"name\":\"mas.jason.written.create.100\"", "\"name\":\"mas.jason.written.create.1000\"");
        assertThat(rsal.run("bench", "mas", "--only", "jason.bare.start", "--repeat", "1", "--json")
                        .out())
                .contains("\"name\":\"mas.jason.bare.start\"");
    }

    @Test
    void aBenchThatIsInterruptedSaysSo() throws Exception {
        Process bench = rsal.start("bench", "sim", "--only", "laser180.1000.core1.rtf", "--repeat", "1000");
        var err = bench.errorReader();
        assertThat(err.readLine()).startsWith("Measuring 1");
        Ended.signal("INT", bench);
        assertThat(err.lines()).anyMatch(line -> line.contains("Interrupted: 0 of 1"));
        assertThat(bench.waitFor()).isEqualTo(130);
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            frobnicate          | 'frobnicate'
            rum                 | Maybe 'run'
                                | Name a command
            run --seed abc      | --seed': 'abc' is not a whole number
            run --seed 1.5      | '1.5'
            run --sped 2        | '--sped'
            run --speed fast    | 'fast'
            run --speed 0       | '0'
            run --for -1        | '-1'
            run --port 70000    | '70000'
            run --set speed     | (NAME=VALUE): 'speed' is not a name and its value
            run --set =2        | '=2'
            run a b             | 'b'
            validate            | SCENARIO
            list things         | things
            bench sin           | Maybe 'sim'
            bench sim --only x9 | 'x9'
            bench sim --only x9 | Names begin with sim.
            bench --repeat 0    | '0'
            bench --repeat x    | 'x' is not a whole number
            help rum            | Maybe 'run'
            """)
    void refusesWhatItCannotUnderstand(String line, String expected) throws Exception {
        Ended ended = Rsal.inProcess(line == null ? new String[0] : line.split(" "));
        assertThat(ended.code()).isEqualTo(Exit.USAGE);
        assertThat(ended.out()).isEmpty();
        assertThat(ended.err()).contains(expected, "--help'").doesNotContain("\tat ");
        assertThat(ended.err().lines()).hasSizeLessThanOrEqualTo(2);
    }

    /// @param line that is put in the place of the one that begins like it
    record FileError(String line, int at, String... expected) {
        String in(String scenario) {
            List<String> lines = new ArrayList<>(scenario.lines().toList());
            lines.set(at - 1, line);
            return String.join("\n", lines);
        }
    }

    static List<FileError> errors() {
        return List.of(
                new FileError("wrold: {map: office}", 6, "'wrold'", "Maybe 'world'"),
                new FileError("world: {map: offcie}", 6, "'offcie'", "office"),
                new FileError("world: {map: maps/none.yaml}", 6, "none.yaml"),
                new FileError(
                        "  guard: {model: pioner2dx, pose: {free: true}}", 8, "'pioner2dx'", "Maybe 'pioneer2dx'"),
                new FileError("  guard: {count: many, model: pioneer2dx}", 8, "'many'", "whole number"),
                new FileError("  guard: {count: 100000, model: pioneer2dx}", 8, "'100000'", "1000"),
                new FileError("  guard: {model: pioneer2dx, pose: [-31.475, 0, 0]}", 8, "'guard'"),
                new FileError("  guard: {model: pioneer2dx, devices: {laser: urg4}}", 8, "'urg4'"),
                new FileError("  guard: {count: $gards, model: pioneer2dx}", 8, "'gards'", "Maybe 'guards'"),
                new FileError("agents: {a: {type: guardian}}\nworld: {map: office}", 6, "'guardian'"),
                new FileError("    - {when: tim > 20, outcome: success}", 12, "tim"),
                new FileError("    - {when: time > 20, outcome: sucess}", 12, "'sucess'", "Maybe 'success'"),
                new FileError("  - {name: collisions, from: sum(collisions)}", 14, "sum"),
                new FileError(
                        "faults: [{kind: gone, robots: gard}]\nworld: {map: office}", 6, "'gard'", "Maybe 'guard'"),
                new FileError(
                        "faults: [{kind: late, delay: -2}]\nworld: {map: office}", 6, "'faults.delay'", "not '-2'"),
                new FileError("world: {map: [office}", 6, "YAML"),
                new FileError("world: !!java.net.URL [x]", 6, "Tags"));
    }

    @ParameterizedTest
    @MethodSource("errors")
    void reportsWhereAScenarioIsWrong(FileError error) throws Exception {
        Path file = Files.writeString(folder.resolve("wrong.yaml"), error.in(GUARD));
        Ended run = Rsal.inProcess("run", file.toString(), "--headless");
        Ended validate = Rsal.inProcess("validate", file.toString());

        assertThat(run.code()).isEqualTo(Exit.INVALID);
        assertThat(run.out()).isEmpty();
        assertThat(run.err())
                .contains("wrong.yaml:%d:".formatted(error.at))
                .contains(error.expected)
                .doesNotContain("\tat ", "Exception");
        assertThat(validate.code()).isEqualTo(Exit.INVALID);
        assertThat(validate.out())
                .contains("wrong.yaml:%d:".formatted(error.at))
                .contains(error.expected);
    }

    @Test
    void startsNothingWhereAScenarioIsWrong() throws Exception {
        FileError error = errors().getFirst();
        Files.writeString(folder.resolve("wrong.yaml"), error.in(GUARD));
        Ended run = rsal.withPage().run("run", "wrong.yaml");
        assertThat(run.code()).isEqualTo(Exit.INVALID);
        assertThat(run.out()).isEmpty();
        assertThat(run.err())
                .contains("wrong.yaml:%d:".formatted(error.at))
                .contains(error.expected)
                .doesNotContain("\tat ", "Watch it at", "Exception");
    }

    @Test
    void refusesAYamlBomb() throws Exception {
        var bomb = new StringBuilder("a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n");
        for (int i = 1; i < 10; i++) {
            bomb.append("a%d: &a%d [".formatted(i, i))
                    .append("*a%d, ".formatted(i - 1).repeat(10))
                    .append("]\n");
        }
        Files.writeString(folder.resolve("bomb.yaml"), bomb);
        Ended ended = rsal.run("run", "bomb.yaml");
        assertThat(ended.code()).isEqualTo(Exit.INVALID);
        assertThat(ended.err()).contains("bomb.yaml").doesNotContain("\tat ");
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            run nowhere                       | 'nowhere'
            run nowhere.yaml                  | nowhere.yaml
            run guard.yaml:fast               | 'fast'
            run guard.yaml --set guards=9     | --set guards=9: 'guards' must be a whole number from 1 to 4
            run guard.yaml --set guards=x     | 'x'
            run guard.yaml --set gards=2      | Maybe 'guards'
            run guard.yaml --mas jsaon        | 'jsaon'
            run guard.yaml --mrs reality      | 'reality'
            show nowhere                      | 'nowhere'
            show amlc                         | Maybe 'amcl'
            show nowhere.yaml                 | nowhere.yaml
            """)
    void refusesWhatDoesNotFitTheScenario(String line, String expected) throws Exception {
        String guard = folder.resolve("guard.yaml").toString();
        Ended ended = Rsal.inProcess(line.replace("guard.yaml", guard).split(" "));
        assertThat(ended.code()).isEqualTo(Exit.INVALID);
        assertThat(ended.out()).isEmpty();
        assertThat(ended.err()).contains(expected).doesNotContain("\tat ");
    }

    @Test
    void runEndsWithOneJsonObject() throws Exception {
        Ended ended = headless("--seed", "7", "--json");
        JsonNode result = JsonMapper.shared().readTree(ended.out());

        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out().lines()).hasSize(1);
        assertThat(result.propertyNames())
                .containsExactly(
                        "scenario",
                        "configuration",
                        "seed",
                        "outcome",
                        "simulatedSeconds",
                        "wallSeconds",
                        "eventHash",
                        "metrics",
                        "endPoses",
                        "topics",
                        "communication",
                        "failed",
                        "unhandledGoals",
                        "arguments",
                        "with");
        assertThat(result.get("scenario").stringValue()).isEqualTo("guard");
        assertThat(result.get("configuration").stringValue()).isEqualTo("short");
        assertThat(result.get("seed").longValue()).isEqualTo(7);
        assertThat(result.get("outcome").stringValue()).isEqualTo("success");
        assertThat(result.get("simulatedSeconds").doubleValue()).isBetween(5.0, 5.2);
        assertThat(result.get("metrics").get("collisions").doubleValue()).isZero();
        assertThat(result.get("metrics").get("firstCollision").isNull()).isTrue();
    }

    private static final String TALK = """
            rsal: 1
            scenario: talk
            world: {map: office}
            robots:
              prey: {model: pioneer2dx, pose: [-12, -1, 0], devices: {laser: urg04lx, localizer: {type: amcl}, pilot: {}}}
              hunter: {model: pioneer3at, pose: [-8, -1, 0], devices: {laser: utm30lx, localizer: {type: amcl}, navigator: {}}}
            agents:
              escape: {type: escape, robot: prey, parameters: {hunter: hunter}}
              follow: {type: follow, robot: hunter, parameters: {prey: prey}}
            communication: {range: 15, behindWalls: 5, loss: 0.5, delay: [0.02, 0.1]}
            """;

    @Test
    void reportsWhoHeardWhatWhereCommunicationIsLimited() throws Exception {
        Files.writeString(folder.resolve("talk.yaml"), TALK);
        Ended shown = rsal.run("show", "talk.yaml");
        assertThat(shown.out())
                .contains(
                        "How agents hear each other",
                        "15.0 m",
                        "5.0 m",
                        "50.0 %",
                        "0.02 to 0.1 s",
                        "as much as wanted");
        Ended ended =
                rsal.run("run", "talk.yaml", "--headless", "--speed", "max", "--seed", "2", "--for", "5", "--json");
        JsonNode heard = JsonMapper.shared().readTree(ended.out()).get("communication");
        assertThat(heard.size()).isPositive();
        assertThat(heard.get(0).propertyNames()).containsExactly("sender", "listener", "topic", "heard", "lost");
        assertThat(heard.get(0).get("sender").stringValue()).isEqualTo("escape");
        assertThat(heard.get(0).get("listener").stringValue()).isEqualTo("follow");
        assertThat(heard.get(0).get("lost").longValue()).isPositive();
    }

    @Test
    void theSameSeedGivesTheSameRunHeadlessOrWatched() throws Exception {
        Ended headless = headless("--json");
        Ended watched =
                rsal.withPage().run("run", "guard.yaml:short", "--once", "--port", "0", "--speed", "max", "--json");
        Ended other = headless("--json", "--seed", "4");

        assertThat(hash(watched)).isEqualTo(hash(headless));
        assertThat(hash(other)).isNotEqualTo(hash(headless));
    }

    private static String hash(Ended ended) {
        return JsonMapper.shared().readTree(ended.out()).get("eventHash").stringValue();
    }

    @Test
    void reportsTheResultToPeople() throws Exception {
        Ended ended = headless("--seed", "7");
        assertThat(ended.out()).contains("guard:short, seed 7", "success", "collisions", "event hash");
    }

    @Test
    void aTimeoutHasAnExitCodeOfItsOwn() throws Exception {
        Ended ended = rsal.run("run", "guard.yaml:late", "--headless", "--speed", "max");
        assertThat(ended.code()).isEqualTo(Exit.NO_SUCCESS);
        assertThat(ended.out()).contains("timeout");
    }

    @Test
    void endsAfterTheTimeThatIsGiven() throws Exception {
        Ended ended = headless("--for", "2", "--json");
        JsonNode result = JsonMapper.shared().readTree(ended.out());
        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(result.get("outcome").stringValue()).isEqualTo("limit");
        assertThat(result.get("simulatedSeconds").doubleValue()).isBetween(2.0, 2.1);
    }

    private Ended headless(String... options) throws Exception {
        var line = new ArrayList<>(List.of("run", "guard.yaml:short", "--headless", "--speed", "max"));
        line.addAll(List.of(options));
        return rsal.apart().run(line.toArray(String[]::new));
    }

    @Trials(
            value = {"INT, 130, --headless", "TERM, 143, --json", "TERM, 143, --headless", "INT, 130, --json"},
            landing = 2)
    void aSignalEndsRunAndPage(String signal, int code, String option) throws Exception {
        Process process = rsal.withPage().start("run", "guard.yaml", "--port", "0", option, "--set", "guards=2");
        BufferedReader err = process.errorReader();
        String first = err.readLine();
        Ended.signal(signal, process);
        Ended ended = Ended.of(process);

        assertThat(ended.code()).isEqualTo(code);
        assertThat(ended.out()).isEmpty();
        assertThat(ended.err()).doesNotContain("\tat ", "Exception");
        if (!option.equals("--headless")) {
            assertThat(first).startsWith("Watch it at http://127.0.0.1:");
            int port = URI.create(first.substring("Watch it at ".length())).getPort();
            assertThat(isOpen(port)).isFalse();
        }
    }

    @Test
    void thePageStaysAfterTheRun() throws Exception {
        Process process = rsal.withPage().start("run", "guard.yaml:short", "--port", "0", "--speed", "max");
        BufferedReader err = process.errorReader();
        int port = URI.create(err.readLine().substring("Watch it at ".length())).getPort();
        assertThat(err.readLine()).contains("guard:short", "seed 3");
        assertThat(err.readLine()).contains("Ctrl-C");
        assertThat(process.isAlive()).isTrue();
        assertThat(isOpen(port)).isTrue();
        Ended.signal("INT", process);
        assertThat(Ended.of(process).out()).contains("guard:short, seed 3", "success");
    }

    @Test
    void aChoiceOfScenariosWaitsForSomebody() throws Exception {
        Process process = rsal.withPage().start("serve", "guard.yaml", "--port", "0");
        URI url = URI.create(process.errorReader().readLine().substring("Choose a scenario at ".length()));
        assertThat(url.getFragment()).endsWith("&choose");
        String port = Integer.toString(url.getPort());
        JsonNode status = JsonMapper.shared()
                .readTree(rsal.run("status", "--port", port, "--json").out());
        assertThat(status.path("scenario").asString()).isEqualTo("guard");
        assertThat(status.path("paused").asBoolean()).isTrue();
        Ended.signal("INT", process);
        assertThat(Ended.of(process).err()).doesNotContain("Running", "real time", "paused");

        Ended wrong = rsal.withPage().run("serve", "nothing.yaml", "--port", "0");
        assertThat(wrong.code()).isEqualTo(Exit.INVALID);
        assertThat(wrong.err()).contains("nothing.yaml").doesNotContain("Choose a scenario at");
    }

    @Test
    @LongTest
    void anAgentIsLookedIntoFromOutside() throws Exception {
        Process process = rsal.withPage().start("run", "hunt-and-prey:advanced", "--port", "0", "--speed", "2");
        String url = process.errorReader().readLine().substring("Watch it at ".length());
        String port = Integer.toString(URI.create(url).getPort());
        Ended mind = rsal.run("agent", "mind", "escape-1", "--port", port);
        for (int look = 0; look < 20 && !mind.out().contains("does: "); look++) { // it may not have begun yet
            mind = rsal.run("agent", "mind", "escape-1", "--port", port);
        }
        assertThat(mind.out())
                .startsWith("Does\n")
                .contains("\nBelieves\n", "\nWants\n", "plans: ", "\nMailbox\n")
                .doesNotContain("shows no goals");
        assertThat(rsal.run("agent", "mind", "follow-1", "--port", port).out()).contains("shows no goals");
        assertThat(mind.code()).isZero();
        assertThat(JsonMapper.shared()
                        .readTree(rsal.run("agent", "mind", "escape-1", "--port", port, "--json")
                                .out())
                        .path("agent")
                        .asString())
                .isEqualTo("escape-1");
        Ended unknown = rsal.run("agent", "mind", "nobody", "--port", port);
        assertThat(unknown.code()).isEqualTo(Exit.USAGE);
        assertThat(unknown.err()).contains("There is no agent 'nobody'. Known are: ", "escape-1, ");
        Ended.signal("INT", process);
        Ended.of(process);
        Ended gone = rsal.run("agent", "mind", "escape-1", "--port", port);
        assertThat(gone.code()).isEqualTo(Exit.UNREACHABLE);
        assertThat(gone.err()).contains("There is no run with a page at 'http://127.0.0.1:" + port + "'.");
    }

    @Test
    void aMindInAgentSpeakIsLookedIntoFromOutside() throws Exception {
        assertThat(mind("follow-1", "prey-1 is at ", "hunt-and-prey:jason"))
                .containsPattern("\nBelieves\n(  .+\n)*  me +me\\('follow-1',follow\\)\\[source\\(percept\\)]\n")
                .containsPattern("\nWants\n(  .+\n)*  [a-z]+ +hunt \\(0\\)\n")
                .containsPattern("\n +does: \\+!hunt: .+\n +plans: hunter\\.asl:\\d+")
                .containsPattern("\nMailbox\n(  .+\n)*  [0-9.]+ s +escape-1 → all +pose +prey-1 is at ")
                .doesNotContain("shows no goals");
    }

    @Test
    @LongTest
    void aMindOnJadeIsLookedIntoFromOutside() throws Exception {
        assertThat(mind("escape-1", "follow-1 → all", "hunt-and-prey:advanced", "--mas", "jade", "--clock", "wall"))
                .containsPattern(
                        "\n(?:Wants|Does not want now)\n  [a-z ]+ +not be caught \\(\\d+\\)\n(  .+\n)* +plans: run\n")
                .containsPattern("\n +does: (not be caught: run|explore: follow the wall)\n")
                .containsPattern("\nMailbox\n(  .+\n)*  [0-9.]+ s +follow-1 → all +[a-z-]+ +.+\n")
                .doesNotContain("shows no goals");
    }

    /// What is told of it when it pursues something and has heard somebody.
    private String mind(String agent, String heard, String... options) throws Exception {
        var words = new ArrayList<>(List.of("run", "--port", "0"));
        words.addAll(List.of(options));
        Process process = rsal.withPage().start(words.toArray(String[]::new));
        try {
            String url = process.errorReader().readLine().substring("Watch it at ".length());
            String port = Integer.toString(URI.create(url).getPort());
            Ended mind = rsal.run("agent", "mind", agent, "--port", port);
            for (int look = 0;
                    look < 30 && !(mind.out().contains("does: ") && mind.out().contains(heard));
                    look++) {
                mind = rsal.run("agent", "mind", agent, "--port", port);
            }
            assertThat(mind.code()).isZero();
            return mind.out();
        } finally {
            Ended.signal("INT", process);
            Ended.of(process);
        }
    }

    @Test
    void anOperatorSeesSendsAndStopsRobotsFromOutside() throws Exception {
        Rsal ours = rsal; // whose folder of pages is its own
        Process process = ours.withPage().start("run", "teleop", "--port", "0", "--seed", "5");
        String url = process.errorReader().readLine().substring("Watch it at ".length());
        String port = Integer.toString(URI.create(url).getPort());
        JsonNode status =
                JsonMapper.shared().readTree(ours.run("status", "--json").out()); // finds the only page
        while (status.path("robots").isEmpty()) { // it may not have begun yet
            status = JsonMapper.shared().readTree(ours.run("status", "--json").out());
        }
        JsonNode first = status.path("robots").path(0);
        assertThat(first.path("id").asString()).isEqualTo("robot-1");
        double x = first.path("x").asDouble();
        String goal = Double.toString(x < 0 ? x + 3 : x - 3);
        String y = Double.toString(first.path("y").asDouble());
        assertThat(ours.run("goal", "robot-1", goal, y).out())
                .matches("Goal 1: 'robot-1' is sent to \\(.*\\), confirmed in \\d+\\.\\d s\\.\\R");
        assertThat(ours.run("status").out()).contains("goal 1: 'robot-1' drives to (");
        assertThat(ours.run("estop", "robot-2", "--port", port).out())
                .startsWith("Motors of 'robot-2' are off, confirmed in ");
        assertThat(ours.run("status").out())
                .startsWith("teleop:virtual, seed 5: runs")
                .contains("motors off");
        JsonNode off = JsonMapper.shared().readTree(ours.run("estop", "--json").out());
        assertThat(off.path("command").asString()).isEqualTo("estop");
        assertThat(off.path("robots").asInt()).isEqualTo(status.path("robots").size());
        assertThat(ours.run("status").out()).contains("motors are off");
        Ended armed = ours.run("arm");
        assertThat(armed.code()).isZero();
        assertThat(armed.out()).contains("stay off: robot-2.", "'rsal arm robot-2'");
        assertThat(ours.run("status").out()).doesNotContain("motors are off").containsOnlyOnce("motors off");
        assertThat(ours.run("arm", "robot-2").out()).startsWith("Motors of 'robot-2' are on, confirmed in ");
        assertThat(ours.run("status").out()).doesNotContain("off");
        assertThat(ours.run("arm").out())
                .startsWith("Motors of %d robots are on"
                        .formatted(status.path("robots").size()));
        Ended there = ours.run("goal", "robot-1", goal, y, "--wait");
        assertThat(there.code()).as(there.out() + there.err()).isZero();
        assertThat(there.out()).contains("Goal 2 of 'robot-1' succeeded after ");
        onlyWhoTakesControlSendsARobotSomebodyElseControls(ours, URI.create(url), goal, y);
        assertThat(ours.run("tell", "behavior", "robot=robot-2", "behavior=stand")
                        .out())
                .startsWith("'behavior' is done, confirmed in ");
        assertThat(ours.run("tell", "behavior", "robot=nobody").err()).contains("There is no 'nobody'");
        Ended wall = ours.run("goal", "robot-1", "900", "900", "90");
        assertThat(wall.code()).isEqualTo(Exit.USAGE);
        assertThat(wall.err()).contains("is outside the map");
        Ended stranger = rsal.inEnvironment(
                        Map.of("XDG_RUNTIME_DIR", folder.resolve("other").toString()))
                .run("estop", "--port", port);
        assertThat(stranger.code()).isEqualTo(Exit.UNREACHABLE);
        assertThat(stranger.err()).contains("There is no page of yours");
        Path key = folder.resolve("rsal/page-%s.token".formatted(port));
        assertThat(Files.getPosixFilePermissions(key)).isEqualTo(PosixFilePermissions.fromString("rw-------"));
        assertThat(ours.run("stop").out()).contains("The run has ended at ", ": stopped, confirmed in ");
        assertThat(ours.run("status").out()).contains("over: stopped");
        Ended.signal("INT", process);
        Ended.of(process);
        assertThat(key).doesNotExist();
    }

    private static void onlyWhoTakesControlSendsARobotSomebodyElseControls(Rsal ours, URI page, String x, String y)
            throws Exception {
        HttpRequest.Builder asAnn = HttpRequest.newBuilder(page.resolve("/api/control"))
                .header("Authorization", "Bearer " + page.getFragment().substring("token=".length()))
                .header("RSAL-Operator", "ann")
                .header("Content-Type", "application/json");
        HttpRequest take = asAnn.POST(BodyPublishers.ofString("{\"name\":\"Ann\",\"over\":true}"))
                .build();
        HttpRequest look = asAnn.GET().build();
        try (var client = HttpClient.newHttpClient()) {
            Ended refused;
            do {
                client.send(take, BodyHandlers.ofString());
                refused = ours.run("goal", "robot-1", x, y);
            } while (!client.send(look, BodyHandlers.ofString()).body().contains("Ann")); // it has run out meanwhile
            assertThat(refused.code()).isEqualTo(Exit.USAGE);
            assertThat(refused.err()).contains("Ann has control", "--take-control");
            assertThat(ours.run("goal", "robot-1", x, y, "--take-control").code())
                    .isZero();
            assertThat(client.send(look, BodyHandlers.ofString()).body()).contains("\"holder\":null");
            assertThat(ours.run("goal", "robot-1", x, y).code()).isZero();
        }
    }

    private static boolean isOpen(int port) {
        try (var _ = new Socket(InetAddress.getLoopbackAddress(), port)) {
            return true;
        } catch (IOException _) {
            return false;
        }
    }

    @Test
    void aPortThatWasAskedForAndIsInUseIsRefused() throws Exception {
        try (var taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Ended ended = rsal.withPage().run("run", "guard.yaml", "--port", Integer.toString(taken.getLocalPort()));
            assertThat(ended.code()).isEqualTo(Exit.UNREACHABLE);
            assertThat(ended.err()).contains("Port " + taken.getLocalPort() + " is in use", "--port 0");
            assertThat(ended.err().lines()).hasSize(1);
        }
    }

    @Test
    void withoutAPageItSaysHowToGetOne() throws Exception {
        Ended ended = rsal.run("run", "guard.yaml");
        assertThat(ended.code()).isEqualTo(Exit.UNREACHABLE);
        assertThat(ended.err()).contains("./rsal", "--headless");
    }

    @Test
    void aReaderThatGoesAwayIsNoError() throws Exception {
        String command = String.join("' '", rsal.command("show", "guard.yaml"));
        Ended ended = Ended.of(new ProcessBuilder("sh", "-c", "'" + command + "' | true")
                .directory(folder.toFile())
                .start());
        assertThat(ended.err()).isEmpty();
        assertThat(ended.code()).isZero();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aFullDiskIsOne() throws Exception {
        String command = String.join("' '", rsal.command("show", "guard.yaml"));
        Ended ended = Ended.of(new ProcessBuilder("sh", "-c", "'" + command + "' > /dev/full")
                .directory(folder.toFile())
                .start());
        assertThat(ended.code()).isEqualTo(Exit.UNREACHABLE);
        assertThat(ended.err()).contains("could not be written").hasLineCount(1);
    }

    @Test
    void colorsAreForTerminalsOnlyAndNotForEverybody() throws Exception {
        Rsal onTerminal = rsal.with("-Drsal.terminal.out=true");
        String escape = "\033[";
        assertThat(onTerminal.run("--help").out()).contains(escape);
        assertThat(onTerminal
                        .inEnvironment(Map.of("NO_COLOR", "1"))
                        .run("--help")
                        .out())
                .doesNotContain(escape);
        assertThat(rsal.run("--help").out()).doesNotContain(escape);
    }

    @Test
    void progressIsDrawnOnTerminalsOnly() throws Exception {
        assertThat(headless().err()).doesNotContain("real time");
        assertThat(rsal.with("-Drsal.terminal.err=true")
                        .run("run", "guard.yaml:short", "--headless", "--speed", "max")
                        .err())
                .contains("real time");
    }

    @Test
    void examplesOfTheDocumentationAreRight() throws Exception {
        Path examples = Path.of("../../docs/examples").toAbsolutePath();
        for (String example : List.of("errands.yaml", "explore.yaml")) {
            Ended ended = rsal.run("validate", examples.resolve(example).toString());
            assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        }
    }

    @Test
    void validateReportsAboutEachFile() throws Exception {
        Files.writeString(folder.resolve("wrong.yaml"), GUARD.replace("pioneer2dx", "pioneer9"));
        Ended ended = rsal.run("validate", "guard.yaml", "wrong.yaml", "--json");
        JsonNode files = JsonMapper.shared().readTree(ended.out()).get("files");

        assertThat(ended.code()).isEqualTo(Exit.INVALID);
        assertThat(files.get(0).get("valid").booleanValue()).isTrue();
        assertThat(files.get(1).get("valid").booleanValue()).isFalse();
        JsonNode problem = files.get(1).get("problems").get(0);
        assertThat(problem.get("file").stringValue()).isEqualTo("wrong.yaml");
        assertThat(problem.get("line").intValue()).isEqualTo(8);
        assertThat(problem.get("message").stringValue()).contains("pioneer9");
        assertThat(rsal.run("validate", "guard.yaml").code()).isEqualTo(Exit.SUCCESS);
    }

    @Test
    void showReportsWhatIsInAScenario() throws Exception {
        Ended text = rsal.run("show", "guard.yaml:late");
        JsonNode json = JsonMapper.shared()
                .readTree(rsal.run("show", "guard.yaml:late", "--json").out());

        assertThat(text.out())
                .contains("guards", "a whole number from 1 to 4", "pioneer2dx", "office", "timeout", "time > 5")
                .contains("Where they start with seed 3", "guard-1   [", "less is better", "at most 0.0");
        assertThat(json.get("configuration").stringValue()).isEqualTo("late");
        assertThat(json.get("robots").get(0).get("model").stringValue()).isEqualTo("pioneer2dx");
        assertThat(json.get("ends").get(0).get("when").stringValue()).isEqualTo("time > 5");
    }

    @Test
    void showReportsWhatIsInAnAgentsFile() throws Exception {
        Files.writeString(folder.resolve("sentry.asl"), """
                // Stands and calls.
                rest(2). // How long it waits [s].
                !guard.
                +!guard : rest(S)
                   <- goto(1, 2);
                      publish(text, "here");
                      .wait(S * 1000);
                      !!guard.
                +heard(pose, Who, _) <- .send(Who, tell, halt).
                """);
        Ended text = rsal.run("show", "sentry.asl");
        assertThat(text.code()).as(text.err()).isEqualTo(Exit.SUCCESS);
        assertThat(text.out().lines())
                .contains(
                        "sentry.asl: an agent",
                        "Stands and calls.",
                        "Needs a robot with Navigator.",
                        "  sentry.asl:3   guard",
                        "  sentry.asl:4   +!guard : rest(S)",
                        "  sentry.asl:9   +heard(pose,Who,_)",
                        "  sentry.asl:6   publish(text,\"here\")",
                        "  sentry.asl:9   .send(Who,tell,halt)",
                        "  pose");
        assertThat(text.out()).containsPattern("rest +2.0 +.* +How long it waits \\[s\\]\\.");

        JsonNode json = JsonMapper.shared()
                .readTree(rsal.run("show", "sentry.asl", "--json").out());
        assertThat(json.get("settings").get(0).get("name").stringValue()).isEqualTo("rest");
        assertThat(json.get("plans").get(1).get("line").asInt()).isEqualTo(9);

        Files.writeString(folder.resolve("sentry.asl"), "!guard.\n+!guard <- godo(1).");
        Ended error = rsal.run("show", "sentry.asl");
        assertThat(error.code()).isEqualTo(Exit.INVALID);
        assertThat(error.err()).contains("sentry.asl:2:12: There is no action 'godo'.");
        assertThat(rsal.run("show", "none.asl").err()).contains("There is no file 'none.asl'.");
    }

    @Test
    void showReportsWhichScenarioJoins() throws Exception {
        Ended text = rsal.run("show", "patrol:distributed"); // an agent is called patrol, too
        JsonNode json = JsonMapper.shared()
                .readTree(rsal.run("show", "patrol:distributed", "--json").out());
        assertThat(text.out())
                .contains("Agents and those of distribution:found, which joins it")
                .contains("robots=guard");
        assertThat(json.get("with").stringValue()).isEqualTo("distribution:found");
    }

    @Test
    void aScenarioJoinsByTheCommandLine() throws Exception {
        assertThat(rsal.run("run", "patrol", "--with", "distribution:found", "--headless", "--for", "1", "--json")
                        .out())
                .contains("\"outcome\":\"limit\"");
        assertThat(rsal.run("run", "patrol", "--with", "distribution:fond", "--headless")
                        .err())
                .contains("--with distribution:fond: Scenario 'distribution' has no configuration 'fond'.", "'found'");
    }

    @Test
    void showReportsWhatGoesWrong() throws Exception {
        Ended text = rsal.run("show", "hunt-and-prey:faulty");
        JsonNode json = JsonMapper.shared()
                .readTree(rsal.run("show", "hunt-and-prey:faulty", "--json").out());
        assertThat(text.out())
                .contains("What goes wrong", "gone and in the way", "lost (20 %)")
                .containsPattern("1 of hunter-1, hunter-2, hunter-3, hunter-4 +at 13.0 s for good");
        assertThat(json.get("faults").get(0).get("pick").intValue()).isEqualTo(1);
        assertThat(json.get("faults").get(1).get("targets").get(0).stringValue())
                .isEqualTo("messages");
    }

    @Test
    void showReportsHowDevicesAreMadeOfOthers() throws Exception {
        Ended text = rsal.run("show", "hunt-and-prey");
        assertThat(text.out())
                .containsSubsequence("Localizer from DriveBase", "Navigator from DriveBase, RangeSensor, Localizer");
    }

    @Test
    void showReportsWhatCanBeSetOfADriver() throws Exception {
        Ended text = rsal.run("show", "amcl");
        assertThat(text.out())
                .contains("makes a Localizer", "DriveBase, RangeSensor")
                .containsPattern("maxRange +30.0 +a number from 0.5 to 200 \\[m] +longer ranges");
    }

    @Test
    void showReportsWhatCanBeSetOfAnAgent() throws Exception {
        Ended ended = rsal.run("show", "follow", "--json");
        JsonNode follow = JsonMapper.shared().readTree(ended.out()).get("found").get(0);
        assertThat(follow.get("kind").stringValue()).isEqualTo("agent");
        assertThat(follow.get("needs").get(0).stringValue()).isEqualTo("Navigator");
        JsonNode prey = follow.get("settings").get(0);
        assertThat(prey.get("type").stringValue()).isEqualTo("robots");
        assertThat(prey.get("value").stringValue()).isEqualTo("prey");
        assertThat(prey.get("max").isNull()).isTrue();
    }

    private static Set<Integer> colors(Path image) throws IOException {
        BufferedImage drawn = ImageIO.read(image.toFile());
        var colors = new HashSet<Integer>();
        for (int x = 0; x < drawn.getWidth(); x++) {
            for (int y = 0; y < drawn.getHeight(); y++) {
                colors.add(drawn.getRGB(x, y) & 0xffffff);
            }
        }
        return colors;
    }

    @Test
    void aWorldWithoutEndNeedsOneWhenNobodyWatches() throws Exception {
        String world = "define cart position ( size [0.4 0.4 0.3] ) cart ( name \"c1\" )\n";
        Files.writeString(folder.resolve("endless.world"), world);
        Files.writeString(folder.resolve("ends.world"), "quit_time 2\n" + world);
        Ended refused = rsal.run("run", "endless.world", "--headless", "--speed", "max");
        assertThat(refused.code()).isEqualTo(Exit.USAGE);
        assertThat(refused.out()).isEmpty();
        assertThat(refused.err()).contains("A world has no stop condition: without a page, add --for SECONDS.");
        Ended reported = rsal.run("run", "endless.world", "--headless", "--speed", "max", "--for", "1", "--json");
        assertThat(reported.code()).as(reported.err()).isZero();
        assertThat(reported.out())
                .contains("\"metrics\":{\"distance.c1\":0.0,\"collisions\":0.0,\"wallCollisions\":0.0}")
                .contains("\"endPoses\":{\"c1\":{\"x\":0.0,\"y\":0.0,\"theta\":0.0}}");
        Ended ends = rsal.run("run", "ends.world", "--headless", "--speed", "max", "--json");
        assertThat(ends.code()).as(ends.err()).isZero();
    }

    @Test
    void optionsAreThoseOfPlayerByTheirNamesHere() throws Exception {
        assertThat(rsal.run("show", "vfh").out())
                .contains("vfh: a controller for 'navigator'", "safetyDist0ms", "sectorAngle");
        Files.writeString(folder.resolve("player.yaml"), """
                rsal: 1
                scenario: player
                world: {map: office}
                robots:
                  r:
                    model: pioneer2dx
                    pose: [0, -1, 0]
                    devices:
                      laser: urg04lx
                      localizer: {type: amcl}
                      navigator:
                        controller: {type: snd, min_gap_width: 0.5}
                        goal_position_tol: 0.2
                agents: {}
                mas: {use: plain}
                mrs: {use: sim}
                run: {stop: [{when: time > 1, outcome: success}]}
                """);
        Ended ended = rsal.run("validate", "player.yaml");
        assertThat(ended.code()).isEqualTo(Exit.INVALID);
        assertThat(ended.err() + ended.out())
                .contains(
                        "player.yaml:12:",
                        "'min_gap_width' is not known in 'robots.r.devices.navigator.controller'",
                        "Maybe 'minGapWidth' was meant?",
                        "player.yaml:13:",
                        "its own tolerance");
    }

    @Test
    @LongTest
    void whatNeedsMoreMemoryThanThereIsEndsAndSaysSo() throws Exception {
        var world = new StringBuilder(
                "define bot position ( size [0.4 0.4 0.3] ranger ( sensor ( range [0 3] samples 12 ) ) ctrl \"wander\" )\n");
        for (int i = 0; i < 5000; i++) {
            world.append("bot ( pose [%d %d 0 0] )%n".formatted(i % 70 * 2, i / 70 * 2));
        }
        Files.writeString(folder.resolve("crowd.world"), world);
        Ended full = rsal.with("-Xmx48m").run("run", "crowd.world", "--headless", "--for", "1");
        assertThat(full.code()).as(full.err()).isEqualTo(Exit.UNREACHABLE);
        assertThat(full.err())
                .contains("of memory that it may have are not enough. Maybe give it more: JAVA_TOOL_OPTIONS=-Xmx")
                .doesNotContain("\tat ");
    }

    @Test
    void configurationsOfPlayerShowRunAndValidate() throws Exception {
        Files.writeString(folder.resolve("lab.world"), """
                define cart position ( size [0.4 0.4 0.3] ranger ( sensor ( range [0 4] fov 180 samples 90 ) ) )
                cart ( name "r0" pose [-2 0 0 0] )
                """);
        String good = """
                driver ( name "stage" plugin "stageplugin" provides ["simulation:0"] worldfile "lab.world" )
                driver ( name "stage" provides ["6667:position2d:0" "6667:ranger:0"] model "r0" )
                driver ( name "rangertolaser" requires ["6667:ranger:0"] provides ["6667:laser:0"] )
                """;
        Files.writeString(folder.resolve("lab.cfg"), good);
        Files.writeString(folder.resolve("wrong.cfg"), good.replace("\"r0\"", "\"r1\""));
        Ended shown = rsal.run("show", "lab.cfg");
        assertThat(shown.code()).as(shown.err()).isZero();
        assertThat(shown.out())
                .contains("Served at ports", "6667   r0", "position2d:0, ranger:0", "rangertolaser on 6667:ranger:0");
        JsonNode json = JsonMapper.shared()
                .readTree(rsal.run("show", "lab.cfg", "--json").out());
        assertThat(json.get("services").get(1).get("robot").stringValue()).isEqualTo("r0");
        Ended checked = rsal.run("validate", "lab.cfg", "wrong.cfg");
        assertThat(checked.code()).isEqualTo(Exit.INVALID);
        assertThat(checked.out())
                .contains("lab.cfg: valid", "wrong.cfg:2:", "There is no model 'r1'", "Maybe 'r0' was meant?");
        Ended run = rsal.run("run", "lab.cfg", "--headless", "--speed", "max", "--for", "2", "--json");
        assertThat(run.code()).as(run.err()).isZero();
        Files.writeString(
                folder.resolve("planner.cfg"),
                "driver ( name \"wavefront\" provides [\"planner:0\"] requires [\"6665:map:0\"] )");
        Ended planner = rsal.run("validate", "planner.cfg");
        assertThat(planner.code()).as(planner.err()).isZero();
        assertThat(planner.out()).contains("planner.cfg: valid, a world with no robots");
        assertThat(rsal.run("show", "planner.cfg").out())
                .contains("planner:0", "wavefront on 6665:map:0", "the world is empty");
        Ended nobody = rsal.run("run", "planner.cfg", "--headless", "--for", "1");
        assertThat(nobody.code()).as("it can be looked at: %s", nobody.err()).isZero();
        Ended converted = rsal.run("convert", "lab.cfg");
        assertThat(converted.code()).isEqualTo(Exit.INVALID);
        assertThat(converted.err()).contains("not a file that can be converted");
    }

    @Test
    void showReportsWhatIsInAWorldAndDrawsIt() throws Exception {
        Files.writeString(folder.resolve("hall.world"), """
                name "hall"
                interval_sim 50
                define wall model ( color "gray30" size [8 0.2 1] )
                define cart position (
                    color "orange" size [0.5 0.4 0.3]
                    ranger ( sensor ( range [0 4] fov 180 samples 90 ) )
                )
                wall ( pose [0 3 0 0] )
                wall ( pose [0 -3 0 0] )
                model ( name "crate" color "red" size [0.6 0.6 0.5] pose [2 1 0 30] )
                cart ( name "c1" pose [-2 0 0 0] ctrl "wander" colour 3 )
                """);
        Ended text = rsal.run("show", "hall.world");
        Ended json = rsal.run("show", "hall.world", "--json", "--image", "drawn.png");
        JsonNode shown = JsonMapper.shared().readTree(json.out());

        assertThat(text.code()).isZero();
        assertThat(text.out())
                .contains("hall", "cart", "1 × differential", "LaserScanner", "wander", "'colour'", "hall.world.png");
        assertThat(shown.get("things").intValue()).isEqualTo(3);
        assertThat(shown.get("robots").get(0).get("ids").get(0).stringValue()).isEqualTo("c1");
        var colors = colors(folder.resolve("drawn.png"));
        assertThat(colors).contains(0xff0000, 0xffa500, 0x4d4d4d, 0xffffff);
        assertThat(colors(folder.resolve("hall.world.png"))).isEqualTo(colors);
        assertThat(rsal.run("show", "guard.yaml", "--image", "x.png").code()).isEqualTo(Exit.USAGE);
        Ended missing = rsal.run("show", "hull.world");
        assertThat(missing.code()).isEqualTo(Exit.INVALID);
        assertThat(missing.err()).contains("There is no file 'hull.world'", "Maybe 'hall.world' was meant?");
        Ended notRun = rsal.run("run", "hull.world", "--headless", "--for", "1");
        assertThat(notRun.code()).isEqualTo(Exit.INVALID);
        assertThat(notRun.err()).contains("There is no file 'hull.world'", "Maybe 'hall.world' was meant?");
        assertThat(folder.resolve("hull.world.png")).doesNotExist();
    }

    @Test
    void aWorldWithNothingInItOrWithoutRobotsIsReported() throws Exception {
        Files.writeString(folder.resolve("empty.world"), "");
        Files.writeString(folder.resolve("still.world"), "model ( )");
        Files.writeString(folder.resolve("blind.world"), "position ( bumper ( ) )");
        String nothing = "There is nothing in this world: no wall, no thing, no robot.";
        assertThat(rsal.run("show", "empty.world").out()).contains("Warnings", nothing, "Maybe it is another file");
        assertThat(rsal.run("show", "still.world").out()).doesNotContain("Warnings");
        String[] run = {"run", "empty.world", "--headless", "--for", "1", "--speed", "max"};
        Ended empty = rsal.run(run);
        assertThat(empty.code()).isZero();
        assertThat(empty.err()).containsOnlyOnce(nothing).contains("Maybe it is another file");
        run[1] = "still.world";
        assertThat(rsal.run(run).err()).contains("There is no robot in this world", "add them on the page");
        Ended converted = rsal.run("convert", "blind.world");
        assertThat(converted.code()).isZero();
        assertThat(converted.err()).contains("blind.world:1:12: This bumper feels nothing");
        run[1] = "blind.world.yaml";
        assertThat(rsal.run(run).err())
                .contains("Bumper 'bumper'", "feels nothing")
                .doesNotContain("no robot");
    }

    private static final String YARD = """
            rsal: 1
            title: yard
            walls: [{line: [[-4, -3], [4, -3], [4, 3], [-4, 3]], closed: true}]
            things: {crate: {pose: [2, 1, 30], body: {length: 0.6, width: 0.6}, color: "#ff0000"}}
            robots: {r0: {model: pioneer2dx, pose: [-2, 0, 0], color: "#ffa500", program: wander}}
            """;

    @Test
    void aWorldInYamlIsShownCheckedAndRun() throws Exception {
        Files.writeString(folder.resolve("yard.world.yaml"), YARD);
        Files.writeString(folder.resolve("wrong.world.yaml"), YARD.replace("color:", "colour:"));
        Files.writeString(folder.resolve("visit.yaml"), """
                rsal: 1
                scenario: visit
                world: {file: yard.world.yaml}
                agents: {roam: {type: wander, robot: r0}}
                """);
        Ended shown = rsal.run("show", "yard.world.yaml", "--image", "yard.png");
        Ended checked = rsal.run("validate", "yard.world.yaml", "wrong.world.yaml", "visit.yaml");
        Ended run = rsal.run("run", "yard.world.yaml", "--headless", "--for", "20", "--speed", "max", "--json");
        Ended again = rsal.run("run", "yard.world.yaml", "--headless", "--for", "20", "--speed", "max", "--json");

        assertThat(shown.out()).contains("yard", "1 × differential", "SonarArray", "wander", "yard.png");
        var colors = colors(folder.resolve("yard.png"));
        assertThat(colors).contains(0xff0000, 0xffa500, 0x808080);
        assertThat(checked.code()).isEqualTo(Exit.INVALID);
        assertThat(checked.out())
                .contains("yard.world.yaml: valid", "visit.yaml: valid")
                .contains("wrong.world.yaml:4:69: 'colour' is not known in 'things.crate'.", "Maybe 'color'");
        assertThat(run.code()).isZero();
        assertThat(JsonMapper.shared().readTree(run.out()).get("eventHash"))
                .isEqualTo(JsonMapper.shared().readTree(again.out()).get("eventHash"));
    }

    private static final String STAGE = """
            name "hall"
            define cart position (
                size [0.5 0.4 0.3] ranger ( pose [0.1 0 0 20] sensor ( range [0 4] fov 177 samples 90 noise [0.001 0 0] ) )
                localization "odom" odom_error [0.03 0 0 0.05]
            )
            model ( name "plan" bitmap "plan.png" size [12 11 1] color "gray30" )
            model ( name "crate" color "red" size [0.6 0.6 0.5] pose [2 1 0 33] )
            cart ( name "c1" pose [-2 0 0 77] ctrl "wander" colour 3 )
            cart ( name "c2" pose [-2 2 0 -120] ctrl "wander" )
            """;

    private void writeStageWorld() throws IOException {
        Files.writeString(folder.resolve("hall.world"), STAGE);
        var plan = new BufferedImage(120, 110, BufferedImage.TYPE_BYTE_GRAY);
        for (int x = 0; x < plan.getWidth(); x++) {
            for (int y = 0; y < plan.getHeight(); y++) {
                boolean border = Math.min(Math.min(x, y), Math.min(119 - x, 109 - y)) < 2 + x % 3;
                plan.setRGB(x, y, border ? 0 : 0xffffff);
            }
        }
        ImageIO.write(plan, "png", folder.resolve("plan.png").toFile());
    }

    @Test
    void convertWritesForGazeboAndReadsThat() throws Exception {
        Files.writeString(folder.resolve("hall.world.yaml"), """
                rsal: 1
                walls: [{length: 4, width: 0.2, center: [0, 3], height: 1}]
                robots: {guard: {model: pioneer2dx, pose: [1, 0, 90], devices: {laser: urg04lx}}}
                """);
        Ended written = rsal.run("convert", "hall.world.yaml", "hall.sdf");
        assertThat(written.code()).as(written.err()).isZero();
        assertThat(written.out()).contains("hall.sdf", "hall.bridge.yaml", "0 boxes of walls, 1 thing, 1 robot");
        assertThat(written.err()).contains("Of devices only lasers are written");
        assertThat(Files.readString(folder.resolve("hall.bridge.yaml"))).contains("/guard/scan");
        assertThat(rsal.run("convert", "hall.world.yaml", "hall.sdf").err()).contains("--force");

        Ended same = rsal.run("convert", "hall.world.yaml", "--sdf", "--force", "--json");
        assertThat(same.code()).as(same.err() + same.out()).isZero();
        assertThat(JsonMapper.shared().readTree(same.out()).get("files").get(0).stringValue())
                .isEqualTo("hall.sdf");
        assertThat(rsal.run("convert", "hall.sdf", "--sdf").err()).contains("'hall.sdf' is SDF already");

        Ended again = rsal.run("convert", "hall.sdf", "again.world.yaml");
        assertThat(again.code()).as(again.err()).isZero();
        assertThat(again.out()).contains("again.world.yaml: 1 thing, 1 robot");
        Ended run = rsal.run("run", "hall.sdf", "--headless", "--speed", "max", "--for", "2", "--json");
        assertThat(run.code()).as(run.err()).isZero();

        Ended scenario = rsal.run("convert", "find-and-collect", "collect.sdf", "--seed", "2", "--json");
        assertThat(scenario.code()).as(scenario.err()).isZero();
        assertThat(JsonMapper.shared().readTree(scenario.out()).get("robots").intValue())
                .isEqualTo(3);
        assertThat(Files.readString(folder.resolve("collect.sdf"))).contains("gz-sim-diff-drive-system");
    }

    @Test
    void convertNamesTheFolderThatIsNotThere() throws Exception {
        Files.writeString(folder.resolve("hall.world"), "position ( )");
        Ended refused = rsal.run("convert", "hall.world", "nowhere/hall.world.yaml");
        assertThat(refused.code()).isEqualTo(Exit.INVALID);
        assertThat(refused.err()).contains("nowhere: There is no such folder.").doesNotContain("Exception");
    }

    @Test
    void convertSaysWhatOfAWorldYamlHasNoPlaceFor() throws Exception {
        Files.writeString(folder.resolve("far.world"), "position ( joules 100 take_watts 1500 )");
        assertThat(rsal.run("convert", "far.world").code()).isZero();
        Files.writeString(folder.resolve("far.world"), "position ( fiducial ( range_max 1500 range_max_id 1 ) )");

        Ended refused = rsal.run("convert", "far.world", "--force");
        assertThat(refused.code()).isEqualTo(Exit.INVALID);
        assertThat(refused.err())
                .contains("far.world: This can't be written in YAML: 'range' must be a number from")
                .containsPattern("It would be far.world.yaml:\\d+:\\d+, which was not written: .*1500");
    }

    @Test
    void convertWritesTheSameWorldInYaml() throws Exception {
        writeStageWorld();
        Ended converted = rsal.run("convert", "hall.world");
        assertThat(converted.code()).as(converted.err()).isZero();
        assertThat(converted.out()).contains("hall.world.yaml: 1 thing, 2 robots", "hall-1.png");
        assertThat(converted.err()).contains("hall.world:8:", "'colour'");
        assertThat(folder.resolve("hall.world.yaml")).content().contains("title: hall", "crate:", "program: wander");

        JsonNode stage = JsonMapper.shared()
                .readTree(rsal.run("run", "hall.world", "--headless", "--for", "30", "--speed", "max", "--json")
                        .out());
        JsonNode own = JsonMapper.shared()
                .readTree(rsal.run("run", "hall.world.yaml", "--headless", "--for", "30", "--speed", "max", "--json")
                        .out());
        assertThat(own.get("eventHash")).isEqualTo(stage.get("eventHash"));
    }

    @Test
    void whatStandsOnActuatorsIsReportedAndConverted() throws Exception {
        Files.writeString(folder.resolve("turret.world"), """
                position ( name "r" ctrl "wander"
                  actuator ( size [0.3 0.1 0.1] type "rotational" start_position 1 max_position 2
                    actuator ( noblocks 1 axis [0 0 1] start_position 0.2
                      ranger ( sensor ( range [0 5] fov 90 samples 10 ) ) ) ) )
                """);
        Ended shown = rsal.run("show", "turret.world");
        assertThat(shown.err()).isEmpty();
        assertThat(shown.out()).contains("actuator-2: Actuator on 'actuator'", "laser: LaserScanner on 'actuator-2'");
        assertThat(rsal.run("convert", "turret.world").code()).isZero();
        assertThat(folder.resolve("turret.world.yaml")).content().contains("laser: {actuator: actuator-2, pose: [");
        String[] run = {"run", "turret.world", "--headless", "--for", "5", "--speed", "max", "--json"};
        JsonNode stage = JsonMapper.shared().readTree(rsal.run(run).out());
        run[1] = "turret.world.yaml";
        JsonNode own = JsonMapper.shared().readTree(rsal.run(run).out());
        assertThat(own.get("eventHash")).isEqualTo(stage.get("eventHash"));
    }

    @Test
    void convertMakesARobotModelOfAUrdfFile() throws Exception {
        Files.copy(
                Path.of("../../middle/models/src/test/resources/rsal/model/urdf/cart.urdf"),
                folder.resolve("cart.urdf"));
        Ended converted = rsal.run("convert", "cart.urdf");
        assertThat(converted.code()).as(converted.err()).isZero();
        assertThat(converted.out()).contains("cart.yaml", "cart-laser.yaml", "robots: {NAME: {model: cart.yaml}}");
        assertThat(converted.err()).contains("cart.urdf:21:", "not a box, cylinder or sphere");
        assertThat(rsal.run("show", "cart.yaml").out()).contains("Cart of a lab", "mounts:");
        Files.writeString(folder.resolve("carts.yaml"), """
                rsal: 1
                scenario: carts
                world: {map: office}
                robots: {cart: {model: cart.yaml, pose: [0, -1, 0], devices: {pilot: {}}}}
                agents: {wander: {type: wander, robot: cart}}
                run: {stop: [{when: time >= 20, outcome: success}]}
                metrics: [{name: way, unit: m, from: distance, bound: {min: 1}}]
                """);
        Ended run = rsal.run("run", "carts.yaml", "--headless", "--speed", "max");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(rsal.run("convert", "cart.urdf").err()).contains("Use --force to overwrite it.");
    }

    @Test
    void convertOverwritesNothingUnlessItIsAskedTo() throws Exception {
        writeStageWorld();
        Path image = Files.writeString(folder.resolve("own-1.png"), "precious");
        Ended refused = rsal.run("convert", "hall.world", "own.world.yaml");
        assertThat(refused.code()).isEqualTo(Exit.INVALID);
        assertThat(refused.err()).contains("own-1.png", "there already", "--force");
        assertThat(folder.resolve("own.world.yaml")).doesNotExist();
        assertThat(image).hasContent("precious");

        Ended forced = rsal.run("convert", "hall.world", "own.world.yaml", "--force", "--json");
        JsonNode reported = JsonMapper.shared().readTree(forced.out());
        assertThat(reported.get("files").get(1).stringValue()).isEqualTo("own-1.png");
        assertThat(reported.get("warnings").get(0).get("line").intValue()).isEqualTo(8);
        assertThat(ImageIO.read(image.toFile()).getWidth()).isEqualTo(120);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            convert                              | 2 | FILE.world
            convert none.world                   | 3 | There is no file 'none.world'
            convert broken.world                 | 3 | broken.world:1:
            convert guard.yaml                   | 3 | not a file that can be converted
            convert good.world out.yaml          | 2 | must end with .world.yaml
            convert good.world no/out.world.yaml | 3 | There is no such folder
            """)
    void convertLeavesNothingBehindWhenItFails(String typed, int code, String expected) throws Exception {
        Files.writeString(folder.resolve("broken.world"), "model ( size [1 2] )");
        Files.writeString(folder.resolve("good.world"), "model ( )");
        Ended ended = rsal.run(typed.split(" "));
        assertThat(ended.code()).isEqualTo(code);
        assertThat(ended.err()).contains(expected);
        try (var files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder("guard.yaml", "broken.world", "good.world");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"scenarios", "maps", "models", "parts", "agents", "drivers", "mas", "mrs", "bridges"})
    void listsWhatThereIs(String what) throws Exception {
        Ended ended = rsal.run("list", what, "--json");
        assertThat(JsonMapper.shared().readTree(ended.out()).get(what))
                .as(ended.out())
                .isNotEmpty()
                .allSatisfy(
                        entry -> assertThat(entry.get("description").asString()).isNotEmpty());
    }

    @Test
    void doctorLooksAtTheMachine() throws Exception {
        Ended ended = rsal.run("doctor", "--json");
        assertThat(ended.code()).isZero();
        assertThat(JsonMapper.shared().readTree(ended.out()).get("findings").findValuesAsString("what"))
                .contains("JDK", "cores", "memory", "Node.js", "Chromium");
    }
}
