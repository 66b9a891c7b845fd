package rsal.bench.scenario;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

/// Whole runs of the scenario `swarm` in a cave of 128 m × 128 m, each repeat with a seed of its own: robots that
/// localize themselves by their sonars, follow walls and tell all others where they are. A run that nobody counts goes
/// before, for the machine to learn the code; what a run needs to begin counts. In those named `driving`, all are sent
/// about by `distribution:found`, each to a place of its own, as soon as the places are found.
///
/// Names are `swarm.<robots>[.driving].core2.<what>`. What: `rtf`, seconds simulated per second; `cpu`, seconds
/// simulated per second of a processor; and `swarm.<robots>[.driving].memory.mb`, all that the process holds while
/// a run goes on.
public final class FleetBench implements Bench {
    private static final Scenario SWARM = Scenario.load("swarm");
    private static final Duration LEARNING = Duration.ofSeconds(10);

    /// @param joined the scenario that is joined to it; empty for none
    /// @param length of a run
    private record Case(String key, String configuration, Optional<String> joined, Duration length) {
        String name(String what) {
            return "swarm.%s.core2.%s".formatted(key, what);
        }

        String memory() {
            return "swarm.%s.memory.mb".formatted(key);
        }

        Stream<String> names() {
            return Stream.of(name("rtf"), name("cpu"), memory());
        }
    }

    private static final List<Case> CASES = List.of(
            new Case("100", "hundred", Optional.empty(), Duration.ofSeconds(60)),
            new Case("100.driving", "hundred", Optional.of("distribution:found"), Duration.ofSeconds(60)),
            new Case("1000", "thousand", Optional.empty(), Duration.ofSeconds(20)));

    @Override
    public List<String> names() {
        return CASES.stream().flatMap(Case::names).toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (Case one : CASES) {
            if (one.names().anyMatch(assignment::wants)) {
                measure(one, assignment);
            }
        }
    }

    private static void measure(Case one, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        double memory = run(one, 0, LEARNING);
        double[] rtf = new double[repeats];
        double[] cpu = new double[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(one.name("runs"), i, repeats);
            var watch = new Stopwatch();
            run(one, i + 1, one.length);
            double seconds = one.length.toMillis() * 1e-3;
            rtf[i] = seconds / watch.wall();
            cpu[i] = seconds / watch.cpu();
        }
        assignment.report(
                Result.more(one.name("rtf"), "s/s", rtf),
                Result.more(one.name("cpu"), "s/s", cpu),
                Result.less(one.memory(), "MB", memory));
    }

    /// @return memory in use shortly before its end, if it is the first [MB]
    private static double run(Case one, long seed, Duration length) {
        var options = RunOptions.NONE
                .withConfiguration(one.configuration)
                .withSeed(seed)
                .withSpeed(Double.POSITIVE_INFINITY)
                .withLimit(length);
        RunOptions whole = one.joined.map(options::withJoined).orElse(options);
        try (var run = LiveRun.start(SWARM.plan(whole))) {
            RunResult result = run.result().toCompletableFuture().join();
            if (!result.outcome().equals("limit")) {
                throw new IllegalStateException(
                        "A run of '%s' ended as '%s' before its time.".formatted(one.configuration, result.outcome()));
            }
            return seed == 0 ? Stopwatch.memory() : Double.NaN;
        }
    }
}
