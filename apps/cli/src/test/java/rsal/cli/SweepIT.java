package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Sweeps as processes of their own: killed, interrupted, gone on with, and told in a report.
class SweepIT {
    private static final String GUARD = """
            rsal: 1
            scenario: guard
            title: Robots wander
            arguments:
              guards: {type: integer, default: 1, min: 1, max: 4, description: How many robots wander.}
            world: {map: office}
            robots:
              guard: {count: $guards, model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, pilot: {}}}
            agents: {wander: {type: wander, robot: guard}}
            run: {stop: [{when: time > 20, outcome: success}]}
            metrics:
              - {name: way, unit: m, from: distance, better: more}
            configurations:
              long: {}
              short: {run: {stop: [{when: time > 5, outcome: timeout}]}}
              real: {run: {clock: {mode: wall}}}
            """;
    private static final List<String> SWEEP = List.of(
            "sweep",
            "guard.yaml",
            "--configuration",
            "long,short",
            "--vary",
            "guards=1:2",
            "--repeat",
            "4",
            "--out",
            "s");

    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    Path folder;

    private Rsal rsal;

    @BeforeEach
    void writeScenario() throws IOException {
        Files.writeString(folder.resolve("guard.yaml"), GUARD);
        rsal = new Rsal(folder);
    }

    @Test
    void aKilledSweepGoesOnWithTheRowsOfOneThatWasNot() throws Exception {
        Ended whole = rsal.run(with("--jobs", "2", "--json"));
        assertThat(whole.code()).as(whole.err()).isEqualTo(Exit.SUCCESS);
        assertThat(whole.err()).doesNotContain("Interrupted");
        JsonNode result = new JsonMapper().readTree(whole.out());
        assertThat(result.get("ended").intValue()).isEqualTo(16);
        assertThat(result.get("combinations")
                        .get(3)
                        .get("outcomes")
                        .get("timeout")
                        .intValue())
                .isEqualTo(4);
        Files.move(folder.resolve("s"), folder.resolve("whole"));

        Process killed = rsal.start(with());
        Path rows = folder.resolve("s/rows.jsonl");
        while (killed.isAlive()
                && (!Files.exists(rows) || Files.readAllLines(rows).size() < 3)) {
            killed.waitFor(20, TimeUnit.MILLISECONDS);
        }
        Ended.signal("KILL", killed);
        Ended.of(killed);
        int there = Files.readString(rows).split("\n", -1).length - 1;
        assertThat(there).isBetween(3, 15);
        String half = "{\"run\":16,\"comb";
        Files.writeString(rows, Files.readString(rows) + half);

        assertThat(rsal.run(with()).code()).as("not by itself").isEqualTo(Exit.INVALID);
        Ended resumed = rsal.run(with("--resume"));
        assertThat(resumed.code()).as(resumed.err()).isEqualTo(Exit.SUCCESS);
        assertThat(resumed.err()).contains("16 runs, of which");
        assertThat(withoutWallTime("s")).isEqualTo(withoutWallTime("whole"));
        assertThat(Files.readAllLines(rows)).hasSize(16);
    }

    @Test
    void aRunIsWhatRunGivesWithItsSeed() throws Exception {
        rsal.run("sweep", "guard.yaml:short", "--set", "guards=2", "--seeds", "7-8", "--out", "s");
        for (String line : Files.readAllLines(folder.resolve("s/rows.jsonl"))) {
            JsonNode row = new JsonMapper().readTree(line);
            Ended alone = rsal.run(
                    "run",
                    "guard.yaml:short",
                    "--set",
                    "guards=2",
                    "--seed",
                    row.get("seed").asString(),
                    "--headless",
                    "--speed",
                    "max",
                    "--json");
            assertThat(row.get("eventHash"))
                    .isEqualTo(new JsonMapper().readTree(alone.out()).get("eventHash"));
        }
    }

    @Trials({"INT, 130", "TERM, 143"})
    void aSignalBreaksItOffAndItCanGoOn(String signal, int code) throws Exception {
        Process process = rsal.start(with());
        assertThat(process.errorReader().readLine()).contains("16 runs");
        Ended.signal(signal, process);
        Ended ended = Ended.of(process);
        assertThat(ended.code()).isEqualTo(code);
        assertThat(ended.out()).isEmpty();
        assertThat(ended.err()).contains("Interrupted", "--resume").doesNotContain("\tat ", "Exception");

        assertThat(rsal.run(with("--resume")).code()).isEqualTo(Exit.SUCCESS);
        Set<Integer> runs = new HashSet<>();
        for (String line : Files.readAllLines(folder.resolve("s/rows.jsonl"))) {
            assertThat(runs.add(new JsonMapper().readTree(line).get("run").intValue()))
                    .isTrue();
        }
        assertThat(runs).hasSize(16);
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            guard.yaml --vary guard=1,2            | 3 | Maybe 'guards' was meant?
            guard.yaml --vary guards=1,9           | 3 | from 1 to 4, not '9'
            guard.yaml --vary guards               | 2 | 'guards' is not a name and its value
            guard.yaml --configuration shrt        | 3 | Maybe 'short' was meant?
            guard.yaml:short --configuration short | 2 | either
            guard.yaml:real                        | 3 | real time
            guard.yaml --repeat 0                  | 2 | '0'
            guard.yaml --seeds five                | 2 | Maybe 20 seeds were meant (20)
            guard.yaml --seeds 5-4                 | 2 | Seeds 5:4 must go up
            guard.yaml --jobs 0                    | 2 | '0'
            guard.yaml --repeat 2 --seeds 1-2      | 2 | either --repeat or --seeds
            guard.yaml --resume                    | 3 | no sweep to resume
            """)
    void saysWhatIsWrongBeforeAnythingStarts(String typed, int code, String message) throws Exception {
        Ended ended = rsal.run(("sweep --out s " + typed).split(" ", -1));
        assertThat(ended.code()).isEqualTo(code);
        assertThat(ended.err()).contains(message).doesNotContain("\tat ");
        assertThat(ended.out()).isEmpty();
        assertThat(folder.resolve("s")).doesNotExist();
    }

    @Test
    @LongTest
    void eachRunIsRecordedWhereThatIsWanted() throws Exception {
        String[] plain = {"sweep", "guard.yaml:short", "--repeat", "3", "--jobs", "2", "--out", "plain"};
        String[] recorded = {"sweep", "guard.yaml:short", "--repeat", "3", "--jobs", "2", "--out", "s", "--record"};
        rsal.run(plain);
        Ended ended = rsal.run(recorded);
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(hashes("s")).hasSize(3).isEqualTo(hashes("plain"));
        for (int run = 1; run <= 3; run++) {
            Ended verified = rsal.run("replay", "s/recordings/" + run + ".mcap", "--verify");
            assertThat(verified.out()).as(verified.err()).startsWith("The same: ");
        }
        rsal.run("report", "s");
        assertThat(folder.resolve("s/report.html")).content().contains("<a href=\"recordings/2.mcap\">2</a>");
    }

    private Set<String> hashes(String sweep) throws IOException {
        var hashes = new TreeSet<String>();
        for (String line : Files.readAllLines(folder.resolve(sweep).resolve("rows.jsonl"))) {
            JsonNode row = new JsonMapper().readTree(line);
            hashes.add(row.get("run").intValue() + " " + row.get("eventHash").asString());
        }
        return hashes;
    }

    @Test
    @LongTest
    void theReportIsOnePage() throws Exception {
        rsal.run("sweep", "guard.yaml:short", "--vary", "guards=1,2", "--repeat", "3", "--out", "s");
        Ended ended = rsal.run("report", "s");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out())
                .contains("s/report.html", "Figures as SVG, PDF, PNG and CSV: s/report-figures", "s/report-tables");
        assertThat(Files.readString(folder.resolve("s/report.html")))
                .contains("guards 1 → 2", "rsal sweep guard.yaml:short --vary guards=1,2")
                .doesNotContain("<script", "http:", "https:");
        assertThat(folder.resolve("s/report-figures/way.png")).isNotEmptyFile();

        assertThat(rsal.run("report", "s", "--out", "paper/x.html").code()).isEqualTo(Exit.UNREACHABLE);
        assertThat(rsal.run("report", "s", "--out", "x.pdf").code()).isEqualTo(Exit.USAGE);
        assertThat(rsal.run("report", "s", "--font", "No Such Font").code()).isEqualTo(Exit.USAGE);
        assertThat(rsal.run("report", "nowhere").err()).contains("no sweep in it");
    }

    private static String[] with(String... more) {
        var words = new ArrayList<>(SWEEP);
        words.addAll(List.of(more));
        return words.toArray(String[]::new);
    }

    /// The table, but for how long runs took.
    private List<String> withoutWallTime(String sweep) throws IOException {
        List<String> lines = Files.readAllLines(folder.resolve(sweep).resolve("rows.csv"));
        int column = List.of(lines.getFirst().split(",", -1)).indexOf("wallSeconds");
        return lines.stream()
                .map(line -> {
                    var cells = new ArrayList<>(List.of(line.split(",", -1)));
                    cells.remove(column);
                    return String.join(",", cells);
                })
                .toList();
    }
}
