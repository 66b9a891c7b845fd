package rsal.jadex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.scenario.run.LiveRun;
import rsal.scenario.run.RunResult;

/// The same scenarios on Jadex as on our own host, to ends that are quick to reach. In real time, so all at once.
@Timeout(600)
class JadexIT {
    @Test
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
