package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

class SteppedRunTest {
    @TempDir
    private Path folder;

    private static RunPlan plan(String scenario, double seconds) {
        return Scenario.load(scenario)
                .plan(RunOptions.NONE
                        .withSeed(7)
                        .withLimit(Duration.ofMillis(Math.round(seconds * 1000)))
                        .withSpeed(Double.POSITIVE_INFINITY));
    }

    @ParameterizedTest
    @ValueSource(strings = {"hunt-and-prey", "find-and-collect", "rescue"})
    void theSamePlanMakesTheSameEventsAsALiveRun(String scenario) {
        RunPlan plan = plan(scenario, 5);
        RunResult live = Runs.result(LiveRun.start(plan));
        try (SteppedRun stepped = SteppedRun.begin(plan)) {
            while (stepped.outcome().isEmpty()) {
                stepped.advance(3);
            }
            RunResult result = stepped.finish();
            assertThat(result.eventHash()).isEqualTo(live.eventHash());
            assertThat(result.metrics()).isEqualTo(live.metrics());
            assertThat(result.outcome()).isEqualTo(live.outcome());
        }
    }

    @Test
    void robotsAndTheirTruthCanBeReadBetweenSteps() {
        try (SteppedRun run = SteppedRun.begin(plan("hunt-and-prey", 100))) {
            run.advance(20);
            assertThat(run.robots()).containsKeys("hunter-1", "prey-1");
            var truth = run.simulation().orElseThrow().truth("prey-1").orElseThrow();
            run.advance(20);
            assertThat(run.simulation().orElseThrow().truth("prey-1").orElseThrow())
                    .isNotEqualTo(truth);
            assertThat(run.metrics()).containsKey("distance.prey-1");
            assertThat(run.finish().outcome()).isEqualTo("stopped");
            assertThat(run.finish()).isSameAs(run.finish());
            assertThat(run.finish().simulatedSeconds()).isEqualTo(4);
        }
    }

    @Test
    void aRunInRealTimeCannotBeAdvanced() {
        RunPlan plan = Runs.plan(
                folder, Runs.TWO_WANDERERS.replace("clock: {speed: max}", "clock: {mode: wall}"), RunOptions.NONE);
        assertThatThrownBy(() -> SteppedRun.begin(plan)).hasMessageContaining("simulated time");
    }
}
