package rsal.jadex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.agent.bdi.Mind.GoalState;
import rsal.engine.LiveRun;
import rsal.engine.report.AgentInspection;
import rsal.engine.report.Answer;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;

/// The same scenarios on Jadex as on our own host, to ends that are quick to reach, in real time, so all at once; and
/// hunters that think by Jadex.
@Timeout(600)
class JadexIT {
    private static final String HUNTERS = "../../docs/examples/jadex-hunters.yaml";

    @Test
    @LongTest
    void threeScenariosSideBySideReachTheirEnds() throws Exception {
        try (var hunt = start("hunt-and-prey", 3, Map.of("catchDistance", "3.0", "hunters", "3"));
                var distribution = start("distribution", 5, Map.of("robots", "3"));
                var collection = LiveRun.start(Scenario.load("find-and-collect")
                        .plan(RunOptions.NONE
                                .inRealTimeOn("jadex")
                                .withConfiguration("near")
                                .withSeed(1)))) {
            assertSuccess(hunt);
            assertSuccess(distribution);
            assertSuccess(collection);
        }
    }

    @Test
    void simulatedTimeIsRefusedWithTheReason() {
        Scenario hunt = Scenario.load("hunt-and-prey");
        assertThatThrownBy(() -> hunt.plan(RunOptions.NONE.withHost("jadex")))
                .hasMessageContaining("The multi-agent system 'jadex' can't follow simulated time")
                .hasMessageContaining("--clock wall");
    }

    @Test
    @LongTest
    void huntersThatThinkByJadexCatchThePreyAndShowWhatTheyWant() throws Exception {
        RunOptions options = RunOptions.NONE.withSeed(4).withArguments(Map.of("catchDistance", "3.0", "hunters", "3"));
        try (var hunt = LiveRun.start(Scenario.load(HUNTERS).plan(options))) {
            AgentInspection hunter = await(untilItWants(hunt, "catch"));
            assertThat(hunter.mail().orElseThrow()).anySatisfy(letter -> {
                assertThat(letter.topic()).isEqualTo("pose");
                assertThat(letter.forAll()).isTrue();
            });
            assertSuccess(hunt);
        }
    }

    /// Completes with what is in a hunter when its mind shows that it is after that.
    private static CompletableFuture<AgentInspection> untilItWants(LiveRun run, String goal) {
        var wanted = new CompletableFuture<AgentInspection>();
        run.onEvents(() -> run.inspector().inside("follow-1").thenAccept(answer -> {
            if (answer instanceof Answer.Seen(AgentInspection hunter)
                    && hunter.mind().stream()
                            .flatMap(mind -> mind.goals().stream())
                            .anyMatch(shown -> shown.name().equals(goal) && shown.state() == GoalState.PURSUED)) {
                wanted.complete(hunter);
            }
        }));
        run.result().thenAccept(early -> wanted.completeExceptionally(new AssertionError(early.outcome())));
        return wanted;
    }

    private static LiveRun start(String scenario, long seed, Map<String, String> arguments) {
        RunOptions options =
                RunOptions.NONE.inRealTimeOn("jadex").withSeed(seed).withArguments(arguments);
        return LiveRun.start(Scenario.load(scenario).plan(options));
    }

    private static void assertSuccess(LiveRun run) throws Exception {
        RunResult result = await(run.result().toCompletableFuture());
        assertThat(result.outcome()).as(result.scenario()).isEqualTo("success");
        assertThat(result.failed()).as(result.scenario()).isEmpty();
    }

    private static <T> T await(CompletableFuture<T> future)
            throws InterruptedException, ExecutionException, TimeoutException {
        return future.get(300, TimeUnit.SECONDS);
    }
}
