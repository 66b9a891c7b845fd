package rsal.server.live;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.ServerClock.await;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.engine.LiveRun;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

@Timeout(60)
class LiveViewSourceTest {
    @Test
    void isFastWhileItsRunGoesByTooFastToBeFollowed() throws Exception {
        var plan = Scenario.load("teleop").plan(RunOptions.NONE.withSpeed(1));
        try (var current = new CurrentRun(plan, _ -> {})) {
            var showing = new LiveViewSource(current);
            showing.look(1);
            assertThat(showing.isFast()).isFalse();
            current.now().run().speed(Double.POSITIVE_INFINITY);
            lookUntil(showing, true);
            current.now().run().speed(1);
            lookUntil(showing, false);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "10, 10, false, false",
        "20, 16, false, true",
        "20, 14, true, true", // looked at more often it would be slower still
        "20, 10, true, false",
        "Infinity, 3, false, false",
        "Infinity, 5, false, true",
        "Infinity, 3, true, true",
        "Infinity, 2, true, false"
    })
    void aRunThatIsToBeAsFastAsItCanIsFastSooner(double speed, double rate, boolean before, boolean fast) {
        assertThat(LiveViewSource.isFast(speed, rate, before)).isEqualTo(fast);
    }

    /// While nobody watches there are few looks, and each is for its words, too.
    @Test
    void whatIsLookedBackOnHasTheWordsOfItsMoment() throws Exception {
        var plan = Scenario.load("teleop").plan(RunOptions.NONE.withSpeed(1));
        try (var current = new CurrentRun(plan, _ -> {})) {
            LiveRun run = current.now().run();
            var showing = new LiveViewSource(current);
            showing.look(10);
            String before = showing.past().at(Duration.ofDays(1)).details();
            run.operator().estop().toCompletableFuture().join();
            run.freshSnapshot().toCompletableFuture().join();
            showing.look(10);
            assertThat(showing.past().at(Duration.ofDays(1)).details())
                    .isNotEqualTo(before)
                    .contains("\"stopped\":true");
        }
    }

    private static void lookUntil(LiveViewSource showing, boolean fast) {
        await().until(() -> {
            boolean isSo = showing.isFast() == fast;
            if (!isSo) {
                showing.look(1);
            }
            return isSo;
        });
    }
}
