package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;

class RecordedOutcomeTest {
    @LongTest
    @Test
    void keepsWhichAgentsFailed() {
        RunPlan plan = Scenario.load("patrol").plan(RunOptions.NONE);
        Map<String, String> failed = Map.of("guard", "a screw is loose");
        var result = new RunResult(
                plan.scenario().name(),
                plan.configuration(),
                plan.seed(),
                "success",
                1,
                2,
                "abc",
                Map.of(),
                List.of(),
                Map.of("guard-1", new Pose2d(1, -2.5, 0.1)),
                failed,
                Map.of("guard", List.of("gaurd(1)")),
                List.of(),
                List.of());
        assertThat(RecordedOutcome.read(RecordedOutcome.entries(Optional.of(result), 0), plan))
                .contains(result);
    }
}
