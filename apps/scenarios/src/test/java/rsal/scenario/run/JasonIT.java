package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

/// Java agents on Jason, in simulated time, beside which those in AgentSpeak run: they do what they do on our own host.
@Timeout(300)
class JasonIT {
    @ParameterizedTest
    @CsvSource({
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
            List<Mail> mail = Runs.mail(run, "follow-1", "pose")
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
            assertThat(mail).anySatisfy(letter -> assertThat(letter.from()).isNotEqualTo("follow-1"));
        }
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
