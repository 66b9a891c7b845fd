package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.Answer;
import rsal.engine.report.RunBroken;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.testkit.LongTest;
import rsal.testkit.example.Metronome;

/// A run that follows the time of another simulator, which the test is.
@Timeout(60)
class DrivenTimeRunTest {
    private static final String SCENARIO = Runs.TWO_WANDERERS
            .replace("type: truthful, error: 0.2", "type: odometry")
            .replace("clock: {speed: max}", "clock: {mode: wall}")
            .replace("      - {when: allCaught(prey), outcome: success}\n", "")
            .replace("run:\n", "mrs: {use: metronome}\nrun:\n");
    private static final Instant BEGINNING = Instant.EPOCH.plusSeconds(500); // of a simulator that has run for a while

    @TempDir
    private Path folder;

    private LiveRun run;
    private Instant now = BEGINNING;

    @BeforeEach
    void start() {
        run = LiveRun.start(Runs.plan(folder, SCENARIO, RunOptions.NONE));
        while (run.freshSnapshot().toCompletableFuture().join().agents().isEmpty()) {
            Metronome.beat(now); // as long as nobody listens, it is lost
            pauseFor(5);
        }
    }

    @AfterEach
    void close() {
        run.close();
    }

    /// Lets the simulator's time go on, a step each millisecond.
    private void beat(long milliseconds) {
        for (long i = 0; i < milliseconds; i += 20) {
            now = now.plusMillis(20);
            Metronome.beat(now);
            pauseFor(1);
        }
    }

    private static void pauseFor(long milliseconds) {
        try {
            TimeUnit.MILLISECONDS.sleep(milliseconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private Duration time() {
        return run.freshSnapshot().toCompletableFuture().join().time();
    }

    @Test
    void itsTimeStandsAndGoesWithTheSimulators() {
        Metronome.beat(now);
        Duration from = time();
        pauseFor(300);
        assertThat(time()).isEqualTo(from); // it is shown all the same
        beat(2_000);
        assertThat(time().minus(from)).isEqualTo(Duration.ofSeconds(2));
    }

    @Test
    @LongTest
    void itsEndIsInTheSimulatorsTime() throws Exception {
        long began = System.nanoTime();
        Metronome.beat(now);
        beat(21_000);
        RunResult result = run.result().toCompletableFuture().get(20, TimeUnit.SECONDS);
        assertThat(result.outcome()).isEqualTo("timeout");
        assertThat(result.simulatedSeconds()).isBetween(20.0, 21.0); // a busy machine lags behind the simulator
        assertThat(Duration.ofNanos(System.nanoTime() - began)).isLessThan(Duration.ofSeconds(15));
    }

    @Test
    void peopleAreAnsweredWhileItStands() throws Exception {
        Metronome.beat(now);
        Answer answer = run.operator().estop().toCompletableFuture().get(10, TimeUnit.SECONDS);
        assertThat(answer).isInstanceOf(Answer.Stopped.class);
        run.stop();
        assertThat(run.result().toCompletableFuture().get(10, TimeUnit.SECONDS).outcome())
                .isEqualTo("stopped");
    }

    @Test
    void aResetOfTheSimulatorEndsItWithOneSentence() {
        Metronome.beat(now);
        beat(2_000);
        Metronome.beat(now.minusMillis(300)); // messages that overtook each other
        Metronome.beat(Instant.EPOCH);
        assertThatThrownBy(() -> Runs.result(run))
                .isInstanceOf(RunBroken.class)
                .hasMessage("The time of the simulator, which the run follows, went back from 502.0 s to 0.0 s."
                        + " Start the run again after a reset.");
    }
}
