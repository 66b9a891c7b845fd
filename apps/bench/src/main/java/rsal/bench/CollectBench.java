package rsal.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import rsal.bench.Plot.Lines.Point;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.scenario.run.LiveRun;
import rsal.scenario.run.RunResult;

/// Whole runs of the scenario `find-and-collect` in the configuration `watched`, where sensors on the ceiling show all
/// cans at once: how fast robots bring them in is a matter of driving and of who gets which. Each repeat has a seed of
/// its own, the same for all that is compared. A run that does not end well counts with the time that it took.
///
/// Names are `collect.<collectors>.rate`, cans collected per minute until all are; `collect.4.bid.sooner`, how much
/// sooner than by asking whoever is free four robots are done when they bid, as a share of that time; and
/// `collect.4.bid.sooner.low` and `.high`, ends of the 95 % confidence interval of its mean (Student's t, two-sided);
/// `collect.4.contacts`, touches in a run.
final class CollectBench implements Bench {
    private static final Scenario SCENARIO = Scenario.load("find-and-collect");
    private static final List<Integer> TEAMS = List.of(1, 2, 4, 8);
    private static final int COMPARED = 4;
    private static final String SOONER = "collect.%d.bid.sooner".formatted(COMPARED);
    private static final String CONTACTS = "collect.%d.contacts".formatted(COMPARED);

    private record Course(double minutes, double cans, double contacts) {}

    private static String rate(int collectors) {
        return "collect.%d.rate".formatted(collectors);
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        TEAMS.forEach(collectors -> names.add(rate(collectors)));
        names.addAll(List.of(SOONER, SOONER + ".low", SOONER + ".high", CONTACTS));
        return names;
    }

    @Override
    public void measure(Assignment assignment) {
        boolean compares =
                names().stream().filter(name -> !name.endsWith(".rate")).anyMatch(assignment::wants);
        var points = new ArrayList<Point>();
        for (int collectors : TEAMS) {
            boolean compared = compares && collectors == COMPARED;
            if (assignment.wants(rate(collectors)) || compared) {
                List<Course> bidding = runs(collectors, "bid", assignment);
                var rate = Result.more(
                        rate(collectors),
                        "1/min",
                        bidding.stream()
                                .mapToDouble(run -> run.cans / run.minutes)
                                .toArray());
                assignment.tell(rate);
                points.add(new Point("bids", collectors, rate.value()));
                if (compared) {
                    compare(bidding, runs(collectors, "first", assignment), assignment);
                }
            }
        }
        assignment.show(new Plot.Lines("Cans collected on the office floor", "robots", "cans per minute", points));
    }

    private static void compare(List<Course> bidding, List<Course> firstFree, Assignment assignment) {
        double[] sooner = new double[bidding.size()];
        for (int i = 0; i < sooner.length; i++) {
            sooner[i] = 1 - bidding.get(i).minutes / firstFree.get(i).minutes;
        }
        double mean = Arrays.stream(sooner).average().orElseThrow();
        double margin = Confidence.margin(sooner);
        assignment.tell(
                Result.more(SOONER, "", sooner),
                Result.more(SOONER + ".low", "", mean - margin),
                Result.more(SOONER + ".high", "", mean + margin),
                Result.less(
                        CONTACTS,
                        "",
                        bidding.stream().mapToDouble(Course::contacts).toArray()));
    }

    private static List<Course> runs(int collectors, String allotment, Assignment assignment) {
        var runs = new ArrayList<Course>();
        for (int i = 0; i < assignment.repeats(); i++) {
            assignment.reach("collect.%d.%s.runs".formatted(collectors, allotment), i, assignment.repeats());
            runs.add(run(collectors, allotment, i + 1));
        }
        return runs;
    }

    private static Course run(int collectors, String allotment, long seed) {
        var options = RunOptions.NONE
                .withConfiguration("watched")
                .withArguments(Map.of("collectors", Integer.toString(collectors), "allotment", allotment))
                .withSeed(seed)
                .withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(SCENARIO.plan(options))) {
            RunResult result = run.result().toCompletableFuture().join();
            double seconds = measure(result, "collectTime", result.simulatedSeconds());
            return new Course(seconds / 60, measure(result, "collected", 0), measure(result, "collisions", 0));
        }
    }

    private static double measure(RunResult result, String name, double otherwise) {
        return result.measures().getOrDefault(name, OptionalDouble.empty()).orElse(otherwise);
    }
}
