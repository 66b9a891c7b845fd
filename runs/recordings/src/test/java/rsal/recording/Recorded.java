package rsal.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import rsal.engine.LiveRun;
import rsal.engine.report.RunObserver;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

/// Runs with a recording.
public final class Recorded {
    private Recorded() {}

    public static RunPlan plan(String scenario, long seed, int seconds) {
        return Scenario.load(scenario)
                .plan(RunOptions.NONE
                        .withSeed(seed)
                        .withSpeed(Double.POSITIVE_INFINITY)
                        .withLimit(Duration.ofSeconds(seconds)));
    }

    public static RunResult run(RunPlan plan, Path file) throws Exception {
        return run(plan, plan, file);
    }

    /// @param reported what the recording says that it is of
    static RunResult run(RunPlan plan, RunPlan reported, Path file) throws Exception {
        return run(plan, reported, file, witness -> witness);
    }

    /// With robots that have [MoreDevices].
    static RunResult runWithMore(RunPlan plan, Path file) throws Exception {
        return run(plan, plan, file, MoreDevices::new);
    }

    private static RunResult run(RunPlan plan, RunPlan reported, Path file, UnaryOperator<RunObserver> seen)
            throws Exception {
        try (Recorder recorder = begin(reported, file)) {
            RunResult result = LiveRun.of(plan)
                    .observer(seen.apply(recorder.observer()))
                    .start()
                    .result()
                    .toCompletableFuture()
                    .get(100, TimeUnit.SECONDS);
            recorder.ended(result);
            return result;
        }
    }

    static Recorder begin(RunPlan plan, Path file) throws IOException {
        var origin = new Origin(plan, "rsal test", "rsal run", Instant.EPOCH);
        return Recorder.begin(file, true, origin, Backlog.Behind.WAIT, System::nanoTime);
    }
}
