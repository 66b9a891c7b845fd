package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

/// Programs of agents that came with a recording.
class UntrustedProgramTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: touched
            title: An agent that leaves a file where it was read
            world: {map: office}
            robots: {r1: {model: pioneer2dx, pose: [0, -1, 0], devices: {}}}
            agents: {touch: {type: Touch.java, parameters: {times: 3, name: somebody, loud: true}}}
            run: {stop: [{when: time > 1, outcome: success}]}
            """;
    private static final String PROGRAM = """
            import java.util.List;
            import rsal.agent.*;
            import rsal.settings.*;

            public class Touch implements AgentType {
                static {
                    System.setProperty("rsal.test.touched", "yes");
                }

                public String key() { return "touch"; }
                public String description() { return "Touches."; }
                public List<Parameter<?>> parameters() {
                    return List.of(
                            Parameter.integer("times", 1, 1, 9, "", ""),
                            Parameter.text("name", "", ""),
                            Parameter.flag("loud", false, ""));
                }
                public Agent create(Arguments arguments) { return self -> self.state("touching"); }
            }
            """;

    @TempDir
    private Path folder;

    private Scenario scenario;

    @BeforeEach
    void read() throws IOException {
        Files.writeString(folder.resolve("Touch.java"), PROGRAM);
        scenario = Scenario.load(
                Files.writeString(folder.resolve("touched.yaml"), SCENARIO).toString());
        assertThat(scenario.plan(RunOptions.NONE).untrusted()).isEmpty();
        assertThat(System.clearProperty("rsal.test.touched")).isEqualTo("yes");
    }

    private RunPlan again(boolean trusted) throws IOException {
        Map<String, byte[]> files = scenario.readFiles();
        assertThat(files).containsKeys("Touch.java", "touched.yaml");
        files.put("Touch.java", (PROGRAM + "// " + trusted).getBytes(StandardCharsets.UTF_8));
        Files.delete(folder.resolve("Touch.java"));
        return Scenario.again(scenario.location().file(), files, trusted).plan(RunOptions.NONE);
    }

    @Test
    void areNotRunButTheRestCanBeLookedAt() throws Exception {
        RunPlan plan = again(false);
        assertThat(System.getProperty("rsal.test.touched")).isNull();
        assertThat(plan.untrusted()).containsExactly("Touch.java");
        assertThat(plan.agents().getFirst().arguments().asMap())
                .containsEntry("name", "somebody")
                .containsEntry("loud", true);
        try (var run = LiveRun.start(plan)) {
            assertThat(run.result().toCompletableFuture().get().failed()).hasSize(1);
        }
        assertThat(System.getProperty("rsal.test.touched")).isNull();
    }

    @Test
    void areRunForWhoeverTrustsThem() throws Exception {
        assertThat(again(true).untrusted()).isEmpty();
        assertThat(System.clearProperty("rsal.test.touched")).isEqualTo("yes");
    }
}
