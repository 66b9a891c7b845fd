package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.ReceivedMessage;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;

/// The same scenarios on JADE as on our own host, to ends that are quick to reach. In real time, so all at once.
@Timeout(600)
class JadeIT {
    private static final RunOptions QUICK_HUNT = jade(3).withArguments(Map.of("catchDistance", "3.0"));

    /// Hunters begin in the corridor, as the prey, so that it takes 10 s, not 50.
    @Test
    void aHuntReachesItsEnd(@TempDir Path folder) throws IOException {
        String shipped =
                Files.readString(Path.of("../scenarios/src/main/resources/rsal/scenarios/hunt-and-prey/scenario.yaml"));
        String near = shipped.replace("[-26.6, 0.9, -17.3, 7.3]", "[-13, -2.4, 10, 0.4]")
                .replaceFirst("success, after: 10", "success, after: 1");
        assertThat(near).isNotEqualTo(shipped);
        try (var hunt = LiveRun.start(Runs.plan(folder, near, QUICK_HUNT))) {
            List<ReceivedMessage> mail = await(Runs.mail(hunt, "follow-1", "pose"));
            assertThat(mail).anySatisfy(letter -> assertThat(letter.from()).isNotEqualTo("follow-1"));
            assertSuccess(hunt);
        }
    }

    @Test
    @LongTest
    void scenariosSideBySideReachTheirEnds() {
        try (var hunt = start("hunt-and-prey", QUICK_HUNT);
                var distribution = start("distribution", jade(5).withArguments(Map.of("robots", "3")))) {
            assertSuccess(hunt);
            assertSuccess(distribution);
        }
    }

    @Test
    @LongTest
    void aCanIsBroughtToItsDepot() {
        try (var collection = start("find-and-collect", jade(1))) {
            assertThat(await(firstDelivery(collection)).subject()).startsWith("can-");
        }
    }

    /// Completes when a can lies in its depot; until all four do, three minutes would pass.
    private static CompletableFuture<RunEvent> firstDelivery(LiveRun run) {
        var delivery = new CompletableFuture<RunEvent>();
        run.onEvents(() -> run.events(0).stream()
                .filter(event -> event.kind().equals("collected"))
                .findFirst()
                .ifPresent(delivery::complete));
        run.result().thenAccept(early -> delivery.completeExceptionally(new AssertionError(early.outcome())));
        return delivery;
    }

    private static RunOptions jade(long seed) {
        return RunOptions.NONE.withConfiguration("jade").withSeed(seed);
    }

    private static LiveRun start(String scenario, RunOptions options) {
        return LiveRun.start(Scenario.load(scenario).plan(options));
    }

    private static void assertSuccess(LiveRun run) {
        RunResult result = await(run.result().toCompletableFuture());
        assertThat(result.outcome()).as(result.scenario()).isEqualTo("success");
        assertThat(result.failed()).as(result.scenario()).isEmpty();
    }

    private static <T> T await(CompletableFuture<T> future) {
        return future.orTimeout(300, TimeUnit.SECONDS).join();
    }
}
