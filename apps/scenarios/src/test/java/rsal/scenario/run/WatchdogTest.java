package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.example.Endless;

@Timeout(120)
class WatchdogTest {
    private static final int PATIENCE = 2; // s

    @TempDir
    Path folder;

    @Test
    void agentThatNeverReturnsIsNamedAndEndsTheRun() throws InterruptedException {
        String text = Runs.TWO_WANDERERS.replace("chase: {type: wanderer, robot: hunter}", "chase: {type: endless}");
        RunPlan plan = Runs.plan(folder, text, RunOptions.NONE);
        LiveRun run = LiveRun.start(plan, 1, System::nanoTime, PATIENCE);
        try {
            assertThatThrownBy(() -> run.result().toCompletableFuture().join())
                    .isInstanceOf(CompletionException.class)
                    .cause()
                    .isInstanceOf(RunBroken.class)
                    .hasMessageContainingAll("Agent (chase) has not returned for 2 s", "Endless");
        } finally {
            Endless.RELEASE.countDown();
        }
        while (run.events(0).stream().noneMatch(event -> event.text().equals("ends: broken"))) {
            Thread.sleep(10); // until it lets go of everything after all
        }
    }
}
