package rsal.cli.grade;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.cli.terminal.ClosedAtExit;
import rsal.cli.terminal.Logging;

/// Runs of several people's agents, some at once.
final class SeededTrials {
    private final Limits limits;

    SeededTrials(Limits limits) {
        this.limits = limits;
    }

    /// @param who whose agent was tried
    /// @param results one for each seed, in their order
    record Trial(String who, List<SeparateRun.Result> results) {
        long successes() {
            return results.stream().filter(SeparateRun.Result::success).count();
        }

        /// What went wrong first; empty when nothing did.
        String firstMessage() {
            return results.stream()
                    .filter(result -> !result.success())
                    .map(result -> result.message().isEmpty() ? result.outcome() : result.message())
                    .findFirst()
                    .orElse("");
        }

        /// Of those that have it.
        double mean(String metric) {
            return results.stream()
                    .map(result -> result.metrics().get(metric))
                    .filter(value -> value != null)
                    .mapToDouble(Double::doubleValue)
                    .average()
                    .orElse(Double.NaN);
        }
    }

    /// Runs all, and waits for them.
    ///
    /// @param runs by whose they are
    /// @param ran is given each result as soon as it is there, on any thread
    /// @param reported is given each person's results, in their order, as soon as they are there
    List<Trial> all(Map<String, SeparateRun> runs, Consumer<SeparateRun.Result> ran, Consumer<Trial> reported)
            throws IOException, InterruptedException {
        Logging.begin();
        var ending = new ClosedAtExit(SeparateRun::endAll);
        var trials = new ArrayList<Trial>();
        var workers = Executors.newFixedThreadPool(limits.jobs);
        try {
            var begun = new LinkedHashMap<String, List<Future<SeparateRun.Result>>>();
            runs.forEach((who, run) -> {
                var invalid = new AtomicReference<SeparateRun.@Nullable Result>();
                begun.put(
                        who,
                        limits.seeds.seeds().stream()
                                .map(seed -> workers.submit(() -> {
                                    SeparateRun.Result result = once(run, seed, invalid);
                                    ran.accept(result);
                                    return result;
                                }))
                                .toList());
            });
            for (var each : begun.entrySet()) {
                var trial = new Trial(each.getKey(), results(each.getValue()));
                trials.add(trial);
                reported.accept(trial);
            }
            ending.checkNoSignal();
            return trials;
        } finally {
            workers.shutdownNow();
            SeparateRun.endAll();
        }
    }

    /// What can't be read is not tried with all seeds.
    private static SeparateRun.Result once(
            SeparateRun run, long seed, AtomicReference<SeparateRun.@Nullable Result> invalid)
            throws IOException, InterruptedException {
        SeparateRun.Result known = invalid.get();
        if (known != null) {
            return known.with(seed);
        }
        SeparateRun.Result result = run.run(seed);
        if (result.isInvalid()) {
            invalid.set(result);
        }
        return result;
    }

    private static List<SeparateRun.Result> results(List<Future<SeparateRun.Result>> runs)
            throws IOException, InterruptedException {
        var results = new ArrayList<SeparateRun.Result>();
        for (Future<SeparateRun.Result> run : runs) {
            try {
                results.add(run.get());
            } catch (ExecutionException e) {
                if (e.getCause() instanceof IOException failed) {
                    throw failed;
                }
                throw new IllegalStateException(e.getCause());
            }
        }
        return results;
    }
}
