package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.ReceivedMessage;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.Trials;

/// Java agents on Jason, in simulated time, beside which those in AgentSpeak run: they do what they do on our own host.
@Timeout(300)
class JasonIT {
    @TempDir
    Path folder;

    @Trials({
        "hunt-and-prey, virtual, 7",
        "hunt-and-prey, advanced, 1",
        "find-and-collect, four-rooms, 1",
        "distribution, virtual, 5"
    })
    void agentsInJavaDoAsOnOurOwnHost(String scenario, String configuration, long seed) {
        RunResult jason = run(scenario, configuration, seed, "jason");
        assertThat(jason.outcome()).isEqualTo("success");
        assertThat(jason.failed()).isEmpty();
        assertThat(jason.eventHash())
                .isEqualTo(run(scenario, configuration, seed, "plain").eventHash());
    }

    @Test
    void whatReachesAnAgentInAgentSpeakIsInItsMailbox() {
        var options = RunOptions.NONE
                .withConfiguration("jason")
                .withSeed(1)
                .withArguments(Map.of("hunters", "2"))
                .withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(Scenario.load("hunt-and-prey").plan(options))) {
            List<ReceivedMessage> mail = Runs.mail(run, "follow-1", "pose")
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
            assertThat(mail).anySatisfy(letter -> assertThat(letter.from()).isNotEqualTo("follow-1"));
        }
    }

    private static final String TALKER = """
            rsal: 1
            scenario: talker
            world: {map: office}
            robots: {r: {model: pioneer2dx, pose: [0, -1, 0]}}
            agents: {talker: {type: talker.asl}}
            mas: {use: jason}
            run: {failedAgents: FAILED, stop: [{when: time > 5, outcome: success}]}
            """;

    private RunResult talk(String failedAgents, String agent, List<RunEvent> events) throws IOException {
        Files.writeString(folder.resolve("talker.asl"), agent);
        Path file = Files.writeString(folder.resolve("talker.yaml"), TALKER.replace("FAILED", failedAgents));
        var options = RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(Scenario.load(file.toString()).plan(options))) {
            RunResult result = Runs.result(run);
            events.addAll(run.events(0));
            return result;
        }
    }

    /// Each line counts, also one that is equal to the last.
    @Test
    void whatAnAgentPrintsIsAnEvent() throws IOException {
        var events = new ArrayList<RunEvent>();
        RunResult result = talk(
                "fail",
                "!go. +!go <- for (.range(I, 1, 3)) { .print(\"beat\"); .wait(1000) }; .println(\"end\").",
                events);
        assertThat(result.outcome()).isEqualTo("success");
        assertThat(events)
                .filteredOn(event -> event.kind().equals("print"))
                .extracting(RunEvent::text)
                .containsExactly("beat", "beat", "beat", "end");
    }

    @Test
    void aGoalWithoutAPlanIsAFailureUnlessThatIsTolerated() throws IOException {
        String agent = "!gaurd(1). +!guard(N) <- .print(N).";
        RunResult result = talk("fail", agent, new ArrayList<>());
        assertThat(result.outcome()).isEqualTo("failure");
        assertThat(result.unhandledGoals()).isEqualTo(Map.of("talker", List.of("gaurd(1)")));
        assertThat(talk("tolerate", agent, new ArrayList<>()).outcome()).isEqualTo("success");
    }

    private static RunResult run(String scenario, String configuration, long seed, String host) {
        var options = RunOptions.NONE
                .withConfiguration(configuration)
                .withSeed(seed)
                .withHost(host)
                .withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(Scenario.load(scenario).plan(options))) {
            assertThat(run.plan().mas().provider().key()).isEqualTo(host);
            return run.result()
                    .toCompletableFuture()
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
        }
    }
}
