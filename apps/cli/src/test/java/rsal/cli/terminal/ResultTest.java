package rsal.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import rsal.cli.sweep.SweepCommand;
import rsal.data.Pose2d;
import rsal.engine.report.RunResult;
import rsal.experiment.Row;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

class ResultTest {
    private static RunPlan plan(RunOptions options) {
        return Scenario.load("patrol").plan(options);
    }

    private static RunResult result(RunPlan plan) {
        return result(plan, Map.of());
    }

    private static RunResult result(RunPlan plan, Map<String, String> failed) {
        return result(plan, "success", failed);
    }

    private static RunResult result(RunPlan plan, String outcome, Map<String, String> failed) {
        return new RunResult(
                plan.scenario().name(),
                plan.configuration(),
                plan.seed(),
                outcome,
                1,
                2,
                "abc",
                Map.of(),
                List.of(),
                Map.of("guard-1", Pose2d.ofDegrees(1, -2.5, 90)),
                failed,
                Map.of("guard", List.of("gaurd(1)")),
                List.of(),
                List.of());
    }

    @Test
    void reportsWhatWasSetAndWhoJoined() {
        RunPlan plan = plan(
                RunOptions.NONE.withArguments(Map.of("guards", "3")).withSeed(4).withJoined("distribution:found"));
        assertThat(new ResultText(plan, result(plan)).toString())
                .startsWith("patrol:virtual with distribution:found, seed 4\n")
                .containsPattern("set +guards=3\n");
        ResultJson json = ResultJson.of(plan, result(plan));
        assertThat(json.endPoses()).containsEntry("guard-1", new ResultJson.EndPose(1, -2.5, Math.PI / 2));
        assertThat(json.with()).contains("distribution:found");
        assertThat(json.arguments()).containsEntry("guards", 3L).containsKeys(argumentsOf(plan));
    }

    @Test
    void anOutcomeThatIsNoneOfTheScenarioIsExplained() {
        RunPlan plan = plan(RunOptions.NONE);
        assertThat(new ResultText(plan, result(plan, "limit", Map.of())).toString())
                .containsPattern("outcome +limit \\(ended by --for\\)\n");
        assertThat(new ResultText(plan, result(plan)).toString()).containsPattern("outcome +success\n");
    }

    @Test
    void sweepIsNoSuccessWhenAnAgentFailedInARun() {
        var failed = Map.of("guard", "a screw is loose");
        assertThat(SweepCommand.exit(List.of(row("failure", Map.of())))).isEqualTo(Exit.SUCCESS);
        assertThat(SweepCommand.exit(List.of(row("success", failed))))
                .as("tolerated")
                .isEqualTo(Exit.SUCCESS);
        assertThat(SweepCommand.exit(List.of(row("success", Map.of()), row("failure", failed))))
                .isEqualTo(Exit.NO_SUCCESS);
    }

    private static Row row(String outcome, Map<String, String> failed) {
        return new Row(
                1,
                1,
                "virtual",
                Map.of(),
                1,
                outcome,
                "",
                OptionalDouble.of(1),
                OptionalDouble.of(2),
                "abc",
                Map.of(),
                List.of(),
                failed);
    }

    private static String[] argumentsOf(RunPlan plan) {
        return plan.arguments().keySet().toArray(String[]::new);
    }

    @Test
    void saysNothingOfThatWhenItIsAsTheScenarioHasIt() {
        RunPlan plan = plan(RunOptions.NONE.withSeed(4));
        assertThat(new ResultText(plan, result(plan)).toString())
                .startsWith("patrol:virtual, seed 4\n")
                .doesNotContain("set ");
        assertThat(ResultJson.of(plan, result(plan)).with()).isEmpty();
    }
}
