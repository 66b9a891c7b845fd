package rsal.bench.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Confidence;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Bars.Bar;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Saving;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

/// Whole runs of the scenario `patrol`, 20 minutes long: guards with balanced tours beside those with other strategies.
///
/// Names are `patrol.<strategy>.<what>`. What: `mean` and `worst`, for how long a place was left alone on average
/// and at most, the mean of all runs ([Confidence]); `contacts`, collisions in a run. And
/// `patrol.balanced.<what>.saved.<strategy>`, how much less that is with balanced tours ([Saving]).
public final class PatrolBench implements Bench {
    private static final Scenario SCENARIO = Scenario.load("patrol");
    private static final String OURS = "balanced";
    private static final List<String> OTHERS = List.of("bids", "partition", "sebs", "cycle", "random");
    private static final List<String> WHATS = List.of("mean", "worst");

    private static String name(String strategy, String what) {
        return "patrol.%s.%s".formatted(strategy, what);
    }

    private static String saved(String strategy, String what) {
        return "patrol.%s.%s.saved.%s".formatted(OURS, what, strategy);
    }

    private static List<String> names(String strategy) {
        var names = new ArrayList<String>();
        WHATS.forEach(what -> names.addAll(Confidence.names(name(strategy, what))));
        names.add(name(strategy, "contacts"));
        return names;
    }

    private static List<String> namesOfSaved(String strategy) {
        return WHATS.stream()
                .flatMap(what -> Saving.names(saved(strategy, what)).stream())
                .toList();
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<>(names(OURS));
        OTHERS.forEach(other -> names.addAll(names(other)));
        OTHERS.forEach(other -> names.addAll(namesOfSaved(other)));
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var bars = new ArrayList<Bar>();
        List<String> compared = OTHERS.stream()
                .filter(other -> assignment.wantsAny(namesOfSaved(other)))
                .toList();
        boolean balanced = !compared.isEmpty() || assignment.wantsAny(names(OURS));
        List<RunResult> ours = balanced ? watch(OURS, assignment, bars) : List.of();
        for (String other : OTHERS) {
            if (compared.contains(other) || assignment.wantsAny(names(other))) {
                List<RunResult> others = watch(other, assignment, bars);
                if (compared.contains(other)) {
                    WHATS.forEach(what -> assignment.report(
                            Saving.of(saved(other, what), "s", idleTimes(ours, what), idleTimes(others, what))));
                }
            }
        }
        assignment.show(
                new Plot.Bars("Four guards and twelve places", "", "time that a place is left alone [s]", bars));
    }

    private static List<RunResult> watch(String strategy, BenchmarkRequest assignment, List<Bar> bars) {
        var options = RunOptions.NONE.withArguments(Map.of("strategy", strategy));
        List<RunResult> runs = SeededRuns.of("patrol." + strategy, SCENARIO, options, assignment);
        for (String what : WHATS) {
            List<Result> mean = Confidence.less(name(strategy, what), "s", idleTimes(runs, what));
            assignment.report(mean);
            bars.add(new Bar(what, strategy, mean.getFirst().value()));
        }
        assignment.report(Result.less(name(strategy, "contacts"), "", SeededRuns.values(runs, "collisions", _ -> 0)));
        return runs;
    }

    private static double[] idleTimes(List<RunResult> runs, String what) {
        return SeededRuns.values(runs, what + "Idleness", _ -> Double.NaN);
    }
}
