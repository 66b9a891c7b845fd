package rsal.bench.scenario;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Confidence;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Lines.Point;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Saving;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

/// Whole runs of the scenario `find-and-collect` in the configuration `watched`, where sensors on the ceiling show all
/// cans at once: how fast robots bring them in is a matter of driving and of who gets which. A run that does not end
/// well counts with the time that it took.
///
/// Names are `collect.<collectors>.rate`, cans collected per minute until all are, the mean of all runs
/// ([Confidence]); `collect.4.bid.sooner`, how much sooner than by asking one that is free four robots are done when
/// they bid ([Saving]); and `collect.4.contacts`, touches in a run.
public final class CollectBench implements Bench {
    private static final Scenario SCENARIO = Scenario.load("find-and-collect");
    private static final List<Integer> TEAMS = List.of(1, 2, 4, 8);
    private static final int COMPARED = 4;
    private static final String SOONER = "collect.%d.bid.sooner".formatted(COMPARED);
    private static final String CONTACTS = "collect.%d.contacts".formatted(COMPARED);

    private static String rate(int collectors) {
        return "collect.%d.rate".formatted(collectors);
    }

    private static List<String> compared() {
        var names = new ArrayList<>(Saving.names(SOONER));
        names.add(CONTACTS);
        return names;
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        TEAMS.forEach(collectors -> names.addAll(Confidence.names(rate(collectors))));
        names.addAll(compared());
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var points = new ArrayList<Point>();
        for (int collectors : TEAMS) {
            boolean compared = collectors == COMPARED && assignment.wantsAny(compared());
            if (assignment.wantsAny(Confidence.names(rate(collectors))) || compared) {
                List<RunResult> bidding = runs(collectors, "bids", assignment);
                double[] minutes = minutes(bidding);
                double[] cans = SeededRuns.values(bidding, "collected", _ -> 0);
                Arrays.setAll(cans, i -> cans[i] / minutes[i]);
                List<Result> rate = Confidence.more(rate(collectors), "1/min", cans);
                assignment.report(rate);
                points.add(new Point("bids", collectors, rate.getFirst().value()));
                if (compared) {
                    assignment.report(Result.less(CONTACTS, "", SeededRuns.values(bidding, "collisions", _ -> 0)));
                    assignment.report(
                            Saving.of(SOONER, "min", minutes, minutes(runs(collectors, "first", assignment))));
                }
            }
        }
        assignment.show(new Plot.Lines("Cans collected on the office floor", "robots", "cans per minute", points));
    }

    private static double[] minutes(List<RunResult> runs) {
        double[] seconds = SeededRuns.values(runs, "collectTime", RunResult::simulatedSeconds);
        return Arrays.stream(seconds).map(each -> each / 60).toArray();
    }

    private static List<RunResult> runs(int collectors, String allotment, BenchmarkRequest assignment) {
        var options = RunOptions.NONE
                .withConfiguration("watched")
                .withArguments(Map.of("collectors", Integer.toString(collectors), "allocation", allotment));
        return SeededRuns.of("collect.%d.%s".formatted(collectors, allotment), SCENARIO, options, assignment);
    }
}
