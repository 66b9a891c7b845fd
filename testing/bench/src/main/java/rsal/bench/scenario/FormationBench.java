package rsal.bench.scenario;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Confidence;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Bars.Bar;
import rsal.bench.measurement.Result;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

/// Whole runs of the scenario `swarm` in the configuration `formation`: six robots that cross a cave in each of the
/// shapes.
///
/// Names are `formation.<shape>.<what>`. What: `error`, true distance of robots to their places while the formation
/// is in place, root mean square of a run [m]; `apart`, share of the run in which it is not; `seconds` until all
/// have arrived, or that the run took. All these are means of all runs ([Confidence]). And `arrived`, share of the
/// robots that do; `contacts`, touches in a run.
public final class FormationBench implements Bench {
    private static final Scenario SCENARIO = Scenario.load("swarm");
    private static final double ROBOTS = 6;
    private static final List<String> SHAPES = List.of("line", "column", "wedge", "circle", "grid");

    private static String name(String shape, String what) {
        return "formation.%s.%s".formatted(shape, what);
    }

    private static List<String> names(String shape) {
        var names = new ArrayList<String>();
        List.of("error", "apart", "seconds").forEach(what -> names.addAll(Confidence.names(name(shape, what))));
        names.addAll(List.of(name(shape, "arrived"), name(shape, "contacts")));
        return names;
    }

    @Override
    public List<String> names() {
        return SHAPES.stream().flatMap(shape -> names(shape).stream()).toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var bars = new ArrayList<Bar>();
        for (String shape : SHAPES) {
            if (assignment.wantsAny(names(shape))) {
                bars.add(measure(shape, assignment));
            }
        }
        assignment.show(new Plot.Bars("Six robots in formation", "", "true distance to places [m]", bars));
    }

    private static Bar measure(String shape, BenchmarkRequest assignment) {
        var options = RunOptions.NONE.withConfiguration("formation").withArguments(Map.of("shape", shape));
        List<RunResult> runs = SeededRuns.of("formation." + shape, SCENARIO, options, assignment);
        double[] apart = SeededRuns.values(runs, "formationTime", RunResult::simulatedSeconds);
        Arrays.setAll(apart, i -> apart[i] / runs.get(i).simulatedSeconds());
        double[] arrived = SeededRuns.values(runs, "arrived", _ -> 0);
        Arrays.setAll(arrived, i -> arrived[i] / ROBOTS);
        List<Result> error =
                Confidence.less(name(shape, "error"), "m", SeededRuns.values(runs, "formationError", _ -> Double.NaN));
        assignment.report(error);
        assignment.report(Confidence.less(name(shape, "apart"), "", apart));
        assignment.report(Confidence.less(
                name(shape, "seconds"), "s", SeededRuns.values(runs, "arrivalTime", RunResult::simulatedSeconds)));
        assignment.report(
                Result.more(
                        name(shape, "arrived"),
                        "",
                        Arrays.stream(arrived).average().orElseThrow()),
                Result.less(name(shape, "contacts"), "", SeededRuns.values(runs, "collisions", _ -> 0)));
        return new Bar("robots", shape, error.getFirst().value());
    }
}
