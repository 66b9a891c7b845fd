package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

@Timeout(60)
class LiveShowingTest {
    @Test
    void isFastWhileItsRunGoesByTooFastToBeFollowed() throws Exception {
        var plan = Scenario.load("teleop").plan(RunOptions.NONE.withSpeed(1));
        try (var current = new CurrentRun(plan, _ -> {})) {
            var showing = new LiveShowing(current);
            showing.look();
            assertThat(showing.isFast()).isFalse();
            current.now().run().speed(Double.POSITIVE_INFINITY);
            lookUntil(showing, true);
            current.now().run().speed(1);
            lookUntil(showing, false);
        }
    }

    private static void lookUntil(LiveShowing showing, boolean fast) throws InterruptedException {
        while (showing.isFast() != fast) {
            Thread.sleep(20);
            showing.look();
        }
    }
}
