package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executors;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Lines.Point;
import rsal.bench.measurement.Result;
import rsal.bench.navigation.ExploreRun.Reached;

/// Robots that map the office floor from scratch, each repeat with a seed of its own: one alone, and two and three
/// that divide the work.
///
/// Names are `explore.office.<robots>.<what>`. What: `share`, how much of the places where robots can be is mapped in
/// the end; `minutes`, of the run until 98 % are, or 60; `contacts`, how often a robot touched something.
public final class ExploreBench implements Bench {
    private static final int MOST_ROBOTS = 3;
    private static final double ENOUGH = 0.98;
    private static final double LONGEST = 60; // minutes
    private static final List<String> WHATS = List.of("share", "minutes", "contacts");

    private static String name(int robots, String what) {
        return "explore.office.%d.%s".formatted(robots, what);
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        for (int robots = 1; robots <= MOST_ROBOTS; robots++) {
            for (String what : WHATS) {
                names.add(name(robots, what));
            }
        }
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var points = new ArrayList<Point>();
        for (int robots = 1; robots <= MOST_ROBOTS; robots++) {
            int count = robots;
            if (WHATS.stream().anyMatch(what -> assignment.wants(name(count, what)))) {
                points.addAll(measure(count, assignment));
            }
        }
        assignment.show(new Plot.Lines("Exploration of the office", "time [min]", "share mapped", points));
    }

    /// @return how the first repeat got on
    private static List<Point> measure(int robots, BenchmarkRequest assignment) {
        var share = new double[assignment.repeats()];
        var minutes = new double[assignment.repeats()];
        var contacts = new double[assignment.repeats()];
        var points = new ArrayList<Point>();
        String series = robots == 1 ? "1 robot" : robots + " robots";
        for (int repeat = 0; repeat < assignment.repeats(); repeat++) {
            var threads = Thread.ofPlatform().daemon().name("explore-", 1).factory();
            try (var worker = Executors.newSingleThreadExecutor(threads);
                    var run = new ExploreRun(robots, repeat + 1, worker)) {
                assignment.reach(name(robots, "runs"), repeat, assignment.repeats());
                List<Reached> course = run.run(ENOUGH, LONGEST);
                share[repeat] = course.getLast().share();
                minutes[repeat] = course.getLast().minutes();
                contacts[repeat] = run.contacts();
                if (repeat == 0) {
                    course.forEach(at -> points.add(new Point(series, at.minutes(), at.share())));
                }
            }
        }
        assignment.report(
                Result.more(name(robots, "share"), "", share),
                Result.less(name(robots, "minutes"), "min", minutes),
                Result.less(name(robots, "contacts"), "", contacts));
        return points;
    }
}
