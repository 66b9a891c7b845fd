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

/// Whole runs of the scenario `swarm:coverage`: robots that map the office floor together, from somewhere on it.
///
/// Names are `coverage.<robots>.<what>`. What: `time90` and `time99`, until so many percent of the floor that they can
/// get to are free on their map, the mean of all runs ([Confidence]), where a run that never gets there counts as long
/// as it took; `share99`, the share of the runs that do get to 99 %; `contacts`, touches in a run.
public final class CoverageBench implements Bench {
    private static final Scenario SCENARIO = Scenario.load("swarm");
    private static final List<Integer> TEAMS = List.of(1, 2, 4, 8);
    private static final List<String> TIMES = List.of("time90", "time99");

    private static String name(int robots, String what) {
        return "coverage.%d.%s".formatted(robots, what);
    }

    private static List<String> names(int robots) {
        var names = new ArrayList<String>();
        TIMES.forEach(time -> names.addAll(Confidence.names(name(robots, time))));
        names.addAll(List.of(name(robots, "share99"), name(robots, "contacts")));
        return names;
    }

    @Override
    public List<String> names() {
        return TEAMS.stream().flatMap(robots -> names(robots).stream()).toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var bars = new ArrayList<Bar>();
        for (int robots : TEAMS) {
            if (assignment.wantsAny(names(robots))) {
                cover(robots, assignment, bars);
            }
        }
        assignment.show(new Plot.Bars(
                "Robots that map the office floor", "robots", "time until so much of it is mapped [s]", bars));
    }

    private static void cover(int robots, BenchmarkRequest assignment, List<Bar> bars) {
        var options =
                RunOptions.NONE.withConfiguration("coverage").withArguments(Map.of("robots", Integer.toString(robots)));
        List<RunResult> runs = SeededRuns.of("coverage." + robots, SCENARIO, options, assignment);
        for (String time : TIMES) {
            double[] seconds = SeededRuns.values(runs, time, RunResult::simulatedSeconds);
            List<Result> mean = Confidence.less(name(robots, time), "s", seconds);
            assignment.report(mean);
            bars.add(new Bar(time, Integer.toString(robots), mean.getFirst().value()));
        }
        double[] reached = SeededRuns.values(runs, "time99", _ -> Double.NaN);
        double whole = (double) Arrays.stream(reached).filter(Double::isFinite).count() / runs.size();
        assignment.report(
                Result.more(name(robots, "share99"), "", whole),
                Result.less(name(robots, "contacts"), "", SeededRuns.values(runs, "collisions", _ -> 0)));
    }
}
