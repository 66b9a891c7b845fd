package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.navigation.OfficeRun.Errand;

/// The navigator on the office floor: three robots at once, each sent from one random place to the next, 200 goals
/// together.
///
/// Names are `navigator.office.<planner>.<what>`, by the local planner. What: `reached`, the share of goals;
/// `contacts`, how often a robot touched something; `ratio`, the time that reached goals took by that of the
/// shortest ways at full speed; `smoothness`, how much the turn rate changed on the way to reached goals [rad/s²], and
/// `roughness`, the same per meter [rad/s/m]; less is smoother.
public final class OfficeBench implements Bench {
    private static final int GOALS = 200;
    private static final List<String> PLANNERS = List.of("vfh", "nd", "snd", "dwa", "mpc");
    private static final List<String> WHATS = List.of("reached", "contacts", "ratio", "smoothness", "roughness");

    private static String name(String planner, String what) {
        return "navigator.office.%s.%s".formatted(planner, what);
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        for (String planner : PLANNERS) {
            WHATS.forEach(what -> names.add(name(planner, what)));
        }
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (String planner : PLANNERS) {
            if (WHATS.stream().anyMatch(what -> assignment.wants(name(planner, what)))) {
                measure(planner, assignment);
            }
        }
    }

    private static void measure(String planner, BenchmarkRequest assignment) {
        double[] reached = new double[assignment.repeats()];
        double[] contacts = new double[assignment.repeats()];
        double[] ratio = new double[assignment.repeats()];
        double[] smoothness = new double[assignment.repeats()];
        double[] roughness = new double[assignment.repeats()];
        for (int repeat = 0; repeat < assignment.repeats(); repeat++) {
            var threads = Thread.ofPlatform().daemon().name("office-", 1).factory();
            try (var worker = Executors.newSingleThreadExecutor(threads);
                    var run = new OfficeRun(Map.of("controller", planner), repeat, worker)) {
                assignment.reach(name(planner, "runs"), repeat, assignment.repeats());
                List<Errand> goals = run.run(GOALS);
                List<Errand> ended = goals.stream().filter(Errand::reached).toList();
                reached[repeat] = (double) ended.size() / goals.size();
                contacts[repeat] = run.contacts();
                ratio[repeat] = ended.stream().mapToDouble(Errand::seconds).sum()
                        / ended.stream().mapToDouble(Errand::shortest).sum();
                double turned = ended.stream().mapToDouble(Errand::roughness).sum();
                smoothness[repeat] =
                        turned / ended.stream().mapToDouble(Errand::seconds).sum();
                roughness[repeat] =
                        turned / ended.stream().mapToDouble(Errand::meters).sum();
            }
        }
        assignment.report(
                Result.more(name(planner, "reached"), "", reached),
                Result.less(name(planner, "contacts"), "", contacts),
                Result.less(name(planner, "ratio"), "", ratio),
                Result.less(name(planner, "smoothness"), "rad/s²", smoothness),
                Result.less(name(planner, "roughness"), "rad/s/m", roughness));
    }
}
