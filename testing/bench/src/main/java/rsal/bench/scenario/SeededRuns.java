package rsal.bench.scenario;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import java.util.stream.LongStream;
import rsal.bench.measurement.AllCores;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

/// Whole runs of a scenario with the seeds 1, 2, 3, …: the same for all that is compared. As many go on at once as
/// there are cores, which changes nothing in them, as their time is simulated.
public final class SeededRuns {
    private SeededRuns() {}

    /// @param name for those who wait (`patrol.bids`)
    /// @return by seed
    public static List<RunResult> of(String name, Scenario scenario, RunOptions options, BenchmarkRequest assignment) {
        List<Long> seeds = LongStream.rangeClosed(1, assignment.seeds()).boxed().toList();
        assignment.reach(name + ".runs", 0, seeds.size());
        return AllCores.each(
                name,
                seeds,
                seed -> run(scenario, options.withSeed(seed)),
                done -> assignment.reach(name + ".runs", done, seeds.size()));
    }

    private static RunResult run(Scenario scenario, RunOptions options) {
        try (var run = LiveRun.start(scenario.plan(options.withSpeed(Double.POSITIVE_INFINITY)))) {
            return run.result().toCompletableFuture().join();
        }
    }

    /// What was measured in each run.
    ///
    /// @param otherwise what counts for a run without
    public static double[] values(List<RunResult> runs, String metric, ToDoubleFunction<RunResult> otherwise) {
        return runs.stream()
                .mapToDouble(run -> {
                    OptionalDouble value = run.metrics().getOrDefault(metric, OptionalDouble.empty());
                    return value.orElseGet(() -> otherwise.applyAsDouble(run));
                })
                .toArray();
    }

    /// Share of the runs that ended in success.
    public static double successes(List<RunResult> runs) {
        return runs.stream()
                .mapToDouble(run -> run.outcome().equals("success") ? 1 : 0)
                .average()
                .orElseThrow();
    }
}
