package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.platform.AgentPlatform;
import rsal.engine.report.AgentView;
import rsal.engine.report.RunEvent;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.testkit.Trials;
import rsal.testkit.example.Witness;

/// The agents of the tutorial are those of this module's tests, and do what it says.
@Timeout(120)
class FirstAgentTest {
    private static final Path TUTORIAL = Path.of("../../docs/tutorials/first-agent.md");
    private static final Path SOURCES = Path.of("src/test/java/own");

    @TempDir
    private Path folder;

    @Test
    void theTutorialShowsWhatIsCompiledAndTestedHere() throws IOException {
        assertThat(blocks("java")).containsExactly(source("Sentry.java"), source("Logbook.java"));
    }

    /// As it is in a folder of one's own, in no package.
    private static String source(String file) throws IOException {
        return Files.readString(SOURCES.resolve(file)).replaceFirst("package own;\n\n", "");
    }

    @BeforeEach
    void putTheAgentsBesideTheScenario() throws IOException {
        for (String file : List.of("Sentry.java", "Logbook.java")) {
            Files.writeString(folder.resolve(file), source(file));
        }
    }

    @Trials({"1", "2", "3"})
    void bothPostsAreVisitedAndWrittenDown(long seed) throws IOException {
        Map<String, AgentPlatform.View> agents = agentsAfter(watch(), seed);
        assertThat(nearest(agents, "first")).isLessThan(0.6);
        assertThat(nearest(agents, "second")).isLessThan(0.6);
        assertThat(agents.get("logbook").beliefs()).containsOnlyKeys("post 1", "post 2");
        assertThat(agents.get("logbook").beliefs().get("post 2")).endsWith("last by sentry");
    }

    @Test
    void aPostThatCanNotBeReachedDoesNotKeepItFromTheOther() throws IOException {
        String text = watch().replace("x1: -8, y1: -1.2", "x1: -31.4, y1: -7.7"); // in the outer wall
        Map<String, AgentPlatform.View> agents = agentsAfter(text, 1);
        assertThat(nearest(agents, "second")).isLessThan(0.6);
        assertThat(agents.get("logbook").beliefs()).containsOnlyKeys("post 2");
    }

    @Trials({"1", "2", "3"})
    void whatThePageShowsIsWhatTheTutorialSays(long seed) throws IOException {
        try (var run = LiveRun.start(plan(watch(), seed))) {
            assertThat(Runs.result(run).outcome()).isEqualTo("success");
            assertThat(run.events(0))
                    .extracting(RunEvent::text)
                    .contains("going to post 2", "guard is at post 1", "Halt, visitor!");
        }
    }

    /// The tutorial's scenario at its end, with witnesses.
    private static String watch() throws IOException {
        return blocks("yaml").getFirst() + """

                configurations:
                  witnessed:
                    agents:
                      logbook: {type: Logbook.java}
                      first: {type: witness, parameters: {of: guard, x: -8, y: -1.2}}
                      second: {type: witness, parameters: {of: guard, x: 0, y: -1.2}}
                """;
    }

    private Map<String, AgentPlatform.View> agentsAfter(String text, long seed) {
        try (var run = LiveRun.start(plan(text, seed))) {
            assertThat(Runs.result(run).outcome()).isEqualTo("success");
            return run.snapshot().agents().stream()
                    .map(AgentView::view)
                    .collect(Collectors.toMap(view -> view.agent().name(), Function.identity()));
        }
    }

    private RunPlan plan(String text, long seed) {
        return Runs.plan(folder, text, RunOptions.NONE.withSeed(seed).withSpeed(Double.POSITIVE_INFINITY));
    }

    private static double nearest(Map<String, AgentPlatform.View> agents, String witness) {
        return Double.parseDouble(agents.get(witness).beliefs().get(Witness.NEAREST));
    }

    private static List<String> blocks(String language) throws IOException {
        return Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL)
                .matcher(Files.readString(TUTORIAL))
                .results()
                .map((MatchResult block) -> block.group(1))
                .toList();
    }
}
