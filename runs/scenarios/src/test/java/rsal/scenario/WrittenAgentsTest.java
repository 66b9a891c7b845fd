package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.settings.InvalidSettings;

/// Agents of a scenario that are written in a language of its host.
class WrittenAgentsTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: own
            title: Own
            arguments:
              pace: {type: number, default: 0.2, description: How fast.}
            world: {map: four-rooms}
            robots:
              r: {model: pioneer2dx, pose: [-3, 2, 0], devices: {laser: urg04lx}}
            agents:
              own: {type: own.asl, robot: r, parameters: {speed: $pace}}
            mas: {use: jason}
            run: {stop: [{when: time > 5, outcome: success}]}
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void write() throws IOException {
        write("own.asl", "speed(0.1). !go. +!go : speed(S) <- drive(S, 0).");
    }

    private void write(String file, String text) throws IOException {
        Files.writeString(folder.resolve(file), text);
    }

    private RunPlan plan(String text) throws IOException {
        write("scenario.yaml", text);
        return Scenario.load(folder.resolve("scenario.yaml").toString()).plan(RunOptions.NONE);
    }

    private void refuses(String text, String... words) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> plan(text))
                .withMessageContainingAll(words);
    }

    @Test
    void theyAreReadBesideTheScenario() throws IOException {
        var agent = plan(SCENARIO).agents().getFirst();
        assertThat(agent.type().key()).isEqualTo("own.asl");
        assertThat(agent.arguments().asMap().get("speed")).isEqualTo(0.2);
        assertThat(agent.robot()).contains("r");
    }

    @Test
    void eachPlatformRunsThem() throws IOException {
        assertThat(plan(SCENARIO.replace("use: jason", "use: plain")).agents())
                .extracting(agent -> agent.type().key())
                .containsExactly("own.asl");
    }

    @Test
    void theirErrorsAreTheScenarios() throws IOException {
        refuses(SCENARIO.replace("own.asl", "none.asl"), "scenario.yaml:10:15: There is no file 'none.asl'.");
        refuses(SCENARIO.replace("own.asl", "../own.asl"), "scenario.yaml:10:15: '../own.asl' lies outside");
        refuses(SCENARIO.replace("speed:", "sped:"), "scenario.yaml:10:47: 'sped' is not known", "Maybe 'speed'");
        refuses(SCENARIO.replace("$pace", "fast"), "'agents.own.parameters.speed' must be a number, not 'fast'");
        refuses(SCENARIO.replace(", robot: r", ""), "Agent 'own.asl' needs a robot with a DriveBase");
        write("own.asl", "speed(0.1).\n!go.\n+!go <- follow_wall.");
        refuses(SCENARIO, "Agent 'own.asl' needs a robot with a Pilot, which robots of role 'r' don't have.");
        write("own.asl", "speed(0.1).\n!go.\n+!go <- drve(1, 0).\n");
        refuses(SCENARIO, "own.asl:3:9: There is no action 'drve'.", "Maybe 'drive'");
    }

    @Test
    void noneIsCalledWhatMeansSomethingElseInTheirLanguage() throws IOException {
        String words = "No agent can be called '%s' beside agents in files '*.asl'";
        refuses(SCENARIO.replace("own: {type", "self: {type"), "scenario.yaml:10:9: " + words.formatted("self"));
        refuses(SCENARIO.replace("own: {type", "percept: {type"), words.formatted("percept"));
        refuses(SCENARIO.replace("agents:\n", "agents:\n  self: {type: blackboard}\n"), words.formatted("self"));
    }

    @Test
    void aNameIsTakenOnlyBesideAgentsOfTheirLanguage() throws IOException {
        String without = SCENARIO.replace(
                "own: {type: own.asl, robot: r, parameters: {speed: $pace}}", "self: {type: blackboard}");
        assertThat(plan(without).agents())
                .extracting(RunPlan.PlannedAgent::name)
                .containsExactly("self");
    }

    @Test
    void thoseOfAScenarioThatJoinsAreReadBesideThat() throws IOException {
        write("greeter.asl", "greeting(\"hi\"). !go. +!go : greeting(G) <- state(G).");
        write("other.yaml", """
                rsal: 1
                scenario: other
                title: Other
                world: {map: four-rooms}
                agents:
                  greet: {type: greeter.asl, parameters: {greeting: good day}}
                mas: {use: jason}
                """);
        var agents = plan(SCENARIO + "with: other.yaml\n").agents();
        assertThat(agents).extracting(agent -> agent.type().key()).containsExactly("own.asl", "greeter.asl");
        assertThat(agents.getLast().arguments().asMap().get("greeting")).isEqualTo("good day");
    }
}
