package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.AgentSpec;
import rsal.agent.OutsideCode;
import rsal.agent.platform.AgentPlatform;
import rsal.agent.platform.AgentTurns;
import rsal.agent.platform.PlainHost;
import rsal.engine.report.RunBroken;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.settings.Arguments;
import rsal.testkit.example.Endless;
import rsal.testkit.fake.TestedType;
import rsal.time.LockstepScheduler;

@Timeout(120)
class WatchdogTest {
    private static final int PATIENCE = 2; // s

    @TempDir
    Path folder;

    @Test
    void agentThatNeverReturnsIsNamedAndEndsTheRun() throws InterruptedException {
        endlessAgentIsNamed(RunOptions.NONE);
    }

    @Test
    void soIsOneThatHasAThreadOfItsOwn() throws InterruptedException {
        endlessAgentIsNamed(RunOptions.NONE.inRealTimeOn("jade"));
    }

    private void endlessAgentIsNamed(RunOptions options) throws InterruptedException {
        LiveRun run = LiveRun.of(plan("endless", options))
                .helpers(1)
                .patience(PATIENCE)
                .start();
        var ended = new CountDownLatch(1);
        run.onEvents(() -> run.events(0).stream()
                .filter(event -> event.text().equals("ends: broken"))
                .findFirst()
                .ifPresent(_ -> ended.countDown()));
        try {
            assertThatThrownBy(() -> run.result().toCompletableFuture().join())
                    .isInstanceOf(CompletionException.class)
                    .cause()
                    .isInstanceOf(RunBroken.class)
                    .hasMessageContainingAll("Agent 'chase' has not returned for 2 s", "Endless");
        } finally {
            Endless.RELEASE.release();
        }
        ended.await(); // until it lets go of everything after all
    }

    @Test
    void anEndlessAgentOfASteppedRunIsNamed() throws InterruptedException {
        var watch = new SteppedWatch(PATIENCE);
        Thread stepping = Thread.ofPlatform().start(() -> {
            try (SteppedRun run = SteppedRun.begin(plan("endless", RunOptions.NONE), watch)) {
                run.advance(20);
            }
        });
        try {
            Optional<String> found = Optional.empty();
            while (found.isEmpty()) {
                Thread.sleep(20);
                found = watch.look();
            }
            assertThat(found.get()).contains("Agent 'chase' has not returned for 2 s", "Endless");
        } finally {
            Endless.RELEASE.release();
        }
        stepping.join();
        assertThat(watch.look()).isEmpty();
    }

    @Test
    void codeOfItElsewhereIsEnded() throws InterruptedException {
        LiveRun run = LiveRun.of(plan("endless", RunOptions.NONE))
                .helpers(1)
                .patience(PATIENCE)
                .start();
        var killed = new CountDownLatch(1);
        Endless.ELSEWHERE.set(() -> {
            Endless.RELEASE.release(); // as the end of a process does
            killed.countDown();
        });
        try {
            assertThatThrownBy(() -> run.result().toCompletableFuture().join()).hasMessageContaining("Endless");
            killed.await();
        } finally {
            Endless.ELSEWHERE.set(() -> {});
        }
    }

    @Test
    void oneWhoseCodeIsDebuggedHasAllTheTimeThatThatNeeds() {
        var turns = new AgentTurns();
        var watchdog = new Watchdog(turns, PATIENCE);
        var run = new LockstepScheduler();
        var platform = new AgentPlatform(run, new PlainHost(run), Optional.empty(), turns);
        var isDebugged = new AtomicBoolean(true);
        var found = new ArrayList<Optional<String>>();
        var agent = new TestedType(self -> {
            self.outside(new OutsideCode() {
                @Override
                public Optional<String> place() {
                    return Optional.empty();
                }

                @Override
                public boolean isDebugged() {
                    return isDebugged.get();
                }

                @Override
                public void kill() {}
            });
            IntStream.range(0, 2 * PATIENCE).forEach(_ -> found.add(watchdog.look()));
            isDebugged.set(false);
            IntStream.rangeClosed(0, PATIENCE).forEach(_ -> found.add(watchdog.look()));
        });
        platform.start(new AgentSpec("amy", "tested", agent, Arguments.defaults(List.of()), Optional.empty(), 1));
        run.advance(Duration.ofSeconds(1));
        platform.close();
        assertThat(found).hasSize(3 * PATIENCE + 1).endsWith(Optional.of("amy"));
        assertThat(found.subList(0, 3 * PATIENCE)).containsOnly(Optional.empty());
    }

    @Test
    void aRunThatBreaksOnAnAgentsThreadEndsOnItsOwn() {
        LiveRun run = LiveRun.start(plan("wrecker", RunOptions.NONE.inRealTimeOn("jade")));
        String thread = run.result()
                .handle((_, _) -> Thread.currentThread().getName())
                .toCompletableFuture()
                .join();
        assertThat(thread).matches("run-[0-9]+");
        assertThatThrownBy(() -> Runs.result(run)).hasMessageContaining("out of order");
    }

    private RunPlan plan(String chaser, RunOptions options) {
        String text =
                Runs.TWO_WANDERERS.replace("chase: {type: wanderer, robot: hunter}", "chase: {type: " + chaser + "}");
        return Runs.plan(folder, text, options);
    }
}
