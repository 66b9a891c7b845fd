package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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

/// Makes scenarios of one's own, and runs what was made, unedited.
class NewIT {
    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    Path folder;

    private Rsal rsal;

    @BeforeEach
    void start() {
        rsal = new Rsal(folder);
    }

    private List<String> made(String name) throws Exception {
        try (var files = Files.list(folder.resolve(name))) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private Ended test(String name, String seeds) throws Exception {
        return rsal.run("test-agent", "%s/%s.yaml".formatted(name, name), "--seeds", seeds);
    }

    @Test
    void aHunterInJavaIsWhatOneBeginsWith() throws Exception {
        Ended ended = rsal.run("new", "chase");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out().lines())
                .contains(
                        "chase/chase.yaml",
                        "chase/Hunter.java",
                        "Run it by   rsal run chase/chase.yaml",
                        "Test it by  rsal test-agent chase/chase.yaml --seeds 3");
        assertThat(made("chase")).containsExactly("Hunter.java", "README.md", "chase.yaml");
        for (String file : made("chase")) {
            assertThat(folder.resolve("chase").resolve(file)).content().doesNotContain(folder.toString());
        }
        assertThat(folder.resolve("chase/README.md")).content().startsWith("# chase\n");
        assertThat(folder.resolve("chase/chase.yaml")).content().contains("\ntitle: 'Chase'\n");

        Ended run = rsal.run("run", "chase/chase.yaml", "--headless", "--speed", "max", "--seed", "3");
        assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
        assertThat(run.out()).startsWith("chase:default, seed 3\n").containsPattern("outcome +success");
        assertThat(test("chase", "1").code()).isEqualTo(Exit.SUCCESS);
        assertThat(rsal.run("show", "chase/Hunter.java").out()).contains("catchDistance", "Navigator");
    }

    @Test
    @LongTest
    void aControllerIsWhatOneBeginsWithWhenOneSaysSo() throws Exception {
        Ended ended = rsal.run("new", "crawl", "--kind", "controller");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(made("crawl")).containsExactly("Cautious.java", "README.md", "crawl.yaml");
        assertThat(folder.resolve("crawl/README.md")).content().contains("a controller in Java", "own-controller.md");
        Ended run = rsal.run("run", "crawl/crawl.yaml", "--headless", "--speed", "max", "--seed", "3");
        assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
        assertThat(run.out()).containsPattern("distance +[\\d.]+ m").containsPattern("wallCollisions +0");
        assertThat(test("crawl", "1").code()).isEqualTo(Exit.SUCCESS);
    }

    @Test
    void aMetricIsWhatOneBeginsWithWhenOneSaysSo() throws Exception {
        Ended ended = rsal.run("new", "spacing", "--kind", "metric");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(made("spacing")).containsExactly("README.md", "Spacing.java", "spacing.yaml");
        assertThat(folder.resolve("spacing/README.md")).content().contains("a metric in Java", "own-metric.md");
        Ended run = rsal.run("run", "spacing/spacing.yaml", "--headless", "--speed", "max", "--seed", "3");
        assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
        assertThat(run.out()).containsPattern("meanSpacing +[\\d.]+ m").containsPattern("encounters +\\d+");
        assertThat(test("spacing", "1").code()).isEqualTo(Exit.SUCCESS);
        assertThat(rsal.run("show", "spacing/Spacing.java").out())
                .contains("Spacing.java: a metric", "mean(spacing)", "near");
        assertThat(rsal.run("new", "other", "--kind", "metric", "--mas", "jason")
                        .code())
                .isEqualTo(Exit.USAGE);
    }

    @Test
    void whatIsWrongInItsAgentIsReportedWithItsLine() throws Exception {
        rsal.run("new", "chase");
        Path agent = folder.resolve("chase/Hunter.java");
        Files.writeString(agent, Files.readString(agent).replace("seen.isEmpty()", "seen.isNobody()"));
        for (String command : List.of("validate", "run")) {
            Ended ended = rsal.run(command, "chase");
            assertThat(ended.code()).isEqualTo(Exit.INVALID);
            assertThat(ended.out() + ended.err())
                    .containsPattern(
                            "Hunter.java:\\d+:\\d+: Java can't compile this: cannot find symbol, symbol: method isNobody");
        }
    }

    /// Whoever made a recording may have written anything into the program of an agent.
    @Test
    @LongTest
    void aRecordingsProgramsAreRunOnlyForThoseWhoTrustIt() throws Exception {
        rsal.run("new", "chase");
        rsal.run("run", "chase", "--headless", "--speed", "max", "--for", "5", "--record", "chase.mcap");
        Files.delete(folder.resolve("chase/Hunter.java"));
        Ended refused = rsal.run("replay", "--verify", "chase.mcap");
        assertThat(refused.code()).isEqualTo(Exit.INVALID);
        assertThat(refused.err()).contains("programs that are in the recording: Hunter.java", "--trust");
        assertThat(rsal.run("show", "chase.mcap").code()).isEqualTo(Exit.SUCCESS);
        Ended trusted = rsal.run("replay", "--verify", "--trust", "chase.mcap");
        assertThat(trusted.code()).as(trusted.err()).isEqualTo(Exit.SUCCESS);
        assertThat(trusted.out()).startsWith("The same: ");
    }

    @Test
    void itsTestFailsWhereTheScenarioDoes() throws Exception {
        rsal.run("new", "chase");
        Path scenario = folder.resolve("chase/chase.yaml");
        String text = Files.readString(scenario);
        Files.writeString(scenario, text.replace("time > 300", "time > 3"));
        assertThat(test("chase", "1").code()).isEqualTo(Exit.NO_SUCCESS);
        Files.writeString(scenario, text.replace("world:", "wrld:"));
        assertThat(test("chase", "1").code()).isEqualTo(Exit.INVALID);
    }

    @Test
    void anAgentInAgentSpeakIsAFileBeside() throws Exception {
        Ended ended = rsal.run("new", "chase", "--mas", "jason", "--json");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode result = JsonMapper.shared().readTree(ended.out());
        assertThat(result.get("run").stringValue()).isEqualTo("chase/chase.yaml");
        assertThat(result.get("files").size()).isEqualTo(3);
        assertThat(made("chase")).containsExactly("README.md", "chase.yaml", "hunter.asl");

        Ended test = test("chase", "3:3");
        assertThat(test.code()).as(test.out() + test.err()).isEqualTo(Exit.SUCCESS);
        assertThat(test.out()).contains("1 of 1 runs ended in success.");
        assertThat(rsal.run("show", "chase/hunter.asl").out()).contains("+!hunt");
    }

    @Test
    void anAgentInPythonIsAFileBeside() throws Exception {
        Ended ended = rsal.run("new", "chase", "--python");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(made("chase")).containsExactly("README.md", "chase.yaml", "hunter.py");
        assertThat(folder.resolve("chase/README.md")).content().contains("an agent in Python");
        assertThat(rsal.run("validate", "chase/chase.yaml").out()).startsWith("chase/chase.yaml: valid");
        assertThat(rsal.run("show", "chase/hunter.py").out())
                .contains("catch_distance", "a number of at least 0.8 [m]");
        Path agent = folder.resolve("chase/hunter.py");
        Files.writeString(agent, Files.readString(agent).replace("min=0.8", "mn=0.8"));
        Ended wrong = rsal.run("run", "chase");
        assertThat(wrong.code()).isEqualTo(Exit.INVALID);
        assertThat(wrong.out() + wrong.err()).containsPattern("hunter.py:\\d+:\\d+: 'Param' has no 'mn'");
    }

    @Trials({"hunt-and-prey", "foraging", "distribution", "find-and-collect", "patrol", "rescue", "swarm", "teleop"})
    void eachThatComesWithRsalCanBeTaken(String scenario) throws Exception {
        Ended ended = rsal.run("new", "mine", "--from", scenario);
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(rsal.run("validate", "mine/mine.yaml").out()).startsWith("mine/mine.yaml: valid");
        Ended run = rsal.run("run", "mine/mine.yaml", "--headless", "--speed", "max", "--for", "3");
        assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
        assertThat(run.out()).startsWith("mine:");

        assertThat(made("mine")).as("an agent of one's own").contains("Watcher.java");
        Ended watched = rsal.run("run", "mine/mine.yaml:own", "--headless", "--speed", "max", "--for", "3");
        assertThat(watched.code()).as(watched.err()).isEqualTo(Exit.SUCCESS);
        assertThat(watched.out()).startsWith("mine:own");
    }

    @Test
    @LongTest
    void itsFolderStandsForItsFile() throws Exception {
        rsal.run("new", "chase", "--from", "hunt-and-prey");
        assertThat(rsal.run("validate", "chase", "chase:jason", "chase:jsaon").out())
                .containsPattern("chase: valid, \\d+ configurations\n")
                .contains("chase:jason: valid\n")
                .contains("chase:jsaon: Scenario 'chase' has no configuration 'jsaon'.", "Maybe 'jason'");
        assertThat(rsal.run("show", "chase:jason").out()).contains("read from chase/chase.yaml");
        Ended run = rsal.run("run", "chase:jason", "--headless", "--speed", "max", "--for", "1");
        assertThat(run.out()).as(run.err()).startsWith("chase:jason, seed 42\n");
        Ended sweep = rsal.run("sweep", "chase:jason", "--seeds", "1-1", "--for", "1", "--out", "swept");
        assertThat(sweep.code()).as(sweep.err()).isEqualTo(Exit.SUCCESS);
    }

    @Test
    void overwritesNothing() throws Exception {
        Files.writeString(Files.createDirectory(folder.resolve("chase")).resolve("mine"), "mine");
        Ended ended = rsal.run("new", "chase");
        assertThat(ended.code()).isEqualTo(Exit.INVALID);
        assertThat(ended.out()).isEmpty();
        assertThat(ended.err()).contains("chase: This is there already.");
        assertThat(made("chase")).containsExactly("mine");
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            new                               | 2 | NAME
            new chase --from hunt             | 3 | There is no scenario 'hunt' to begin with.
            new chase --from my.yaml          | 3 | There is no scenario 'my.yaml' to begin with.
            new chase --mas jsaon             | 2 | There is no multi-agent system 'jsaon'. Maybe 'jason' was meant?
            new chase --mas jade              | 2 | 'jade' runs the same agents as 'plain'
            new chase --mas jason --from swarm | 2 | Remove --from swarm.
            new 2nd                           | 3 | A scenario can't be called '2nd'.
            new patrol                        | 3 | A scenario that comes with RSAL is called 'patrol'.
            new none/chase                    | 5 | There is no folder
            """)
    void refusesWhatItCannotMake(String line, int code, String expected) throws Exception {
        Ended ended = rsal.run(line.split(" ", -1));
        assertThat(ended.code()).as(ended.err()).isEqualTo(code);
        assertThat(ended.err()).contains(expected);
        assertThat(folder).isEmptyDirectory();
    }
}
