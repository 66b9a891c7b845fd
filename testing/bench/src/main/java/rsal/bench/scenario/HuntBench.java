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

/// Whole runs of the scenario `hunt-and-prey` in the configuration `advanced`: hunters that bid for clever prey and cut
/// them off, beside those of the thesis, each of which has its prey from the beginning and goes straight for it
/// (`fixed`). A hunt in which not all are caught counts with the time that it took.
///
/// Names are `hunt.<assignment>.<what>`. What: `seconds` until all are caught, the mean ([Confidence]); `caught`, share
/// of the hunts in which all are; `contacts`, touches in a hunt. And `hunt.bids.sooner`, how much sooner all are caught
/// by bids ([Saving]).
public final class HuntBench implements Bench {
    private static final Scenario SCENARIO = Scenario.load("hunt-and-prey");
    private static final String BIDS = "bids";
    private static final String FIXED = "fixed";
    private static final String SOONER = "hunt.bids.sooner";

    private static String name(String how, String what) {
        return "hunt.%s.%s".formatted(how, what);
    }

    private static List<String> names(String how) {
        var names = new ArrayList<>(Confidence.names(name(how, "seconds")));
        names.addAll(List.of(name(how, "caught"), name(how, "contacts")));
        return names;
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<>(names(BIDS));
        names.addAll(names(FIXED));
        names.addAll(Saving.names(SOONER));
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        boolean compares = assignment.wantsAny(Saving.names(SOONER));
        var bars = new ArrayList<Bar>();
        double[] bidding = compares || assignment.wantsAny(names(BIDS)) ? hunt(BIDS, assignment, bars) : new double[0];
        if (compares || assignment.wantsAny(names(FIXED))) {
            double[] fixed = hunt(FIXED, assignment, bars);
            if (compares) {
                assignment.report(Saving.of(SOONER, "s", bidding, fixed));
            }
        }
        assignment.show(new Plot.Bars("Three clever prey and four hunters", "", "time until all are caught [s]", bars));
    }

    /// @return how long each hunt took [s]
    private static double[] hunt(String how, BenchmarkRequest assignment, List<Bar> bars) {
        var options = RunOptions.NONE.withConfiguration("advanced").withArguments(Map.of("assignment", how));
        List<RunResult> runs = SeededRuns.of("hunt." + how, SCENARIO, options, assignment);
        double[] seconds = SeededRuns.values(runs, "captureTime", RunResult::simulatedSeconds);
        List<Result> mean = Confidence.less(name(how, "seconds"), "s", seconds);
        assignment.report(mean);
        assignment.report(
                Result.more(name(how, "caught"), "", SeededRuns.successes(runs)),
                Result.less(name(how, "contacts"), "", SeededRuns.values(runs, "collisions", _ -> 0)));
        bars.add(new Bar("hunters", how, mean.getFirst().value()));
        return seconds;
    }
}
