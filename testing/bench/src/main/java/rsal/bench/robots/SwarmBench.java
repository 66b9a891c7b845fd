package rsal.bench.robots;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.jspecify.annotations.Nullable;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.bench.place.Cave;
import rsal.bench.robots.WanderingRobots.Kind;
import rsal.data.OccupancyGrid;

/// The simulator: wandering robots in a cave of 128 m × 128 m, cells of 0.05 m, 10 steps a second.
///
/// Names are `sim.<kind>.<robots>.core<n>.<what>`. What: `rtf`, seconds simulated per second; `cpu`, seconds
/// simulated per second of a processor; `rays` per second; `bytes` allocated per step and robot; and
/// `sim.<kind>.<robots>.memory.mb`, all that the process holds.
public final class SwarmBench implements Bench {
    private static final double SIDE = 128; // [m]
    private static final double RESOLUTION = 0.05; // [m]
    private static final long SEED = 1;
    private static final double STEPS_PER_SECOND = 10;
    private static final double WARM = 6; // [s]
    private static final double WORTH_MEASURING = 1; // [s]

    private @Nullable OccupancyGrid cave;

    private record Case(Kind kind, int robots, int cores) {
        String name(String what) {
            return "sim.%s.%d.core%d.%s".formatted(kind.label(), robots, cores, what);
        }

        String memory() {
            return "sim.%s.%d.memory.mb".formatted(kind.label(), robots);
        }

        List<String> names() {
            var names = new ArrayList<>(List.of(name("rtf"), name("cpu"), name("rays"), name("bytes")));
            if (cores == 1) {
                names.add(memory());
            }
            return names;
        }
    }

    private static final List<Case> CASES = cases();

    private static List<Case> cases() {
        var cases = new ArrayList<Case>();
        for (int cores = 1; cores <= 2; cores++) {
            cases.add(new Case(Kind.LASER180, 100, cores));
            cases.add(new Case(Kind.LASER180, 1000, cores));
            cases.add(new Case(Kind.SONAR16, 100, cores));
            cases.add(new Case(Kind.SONAR16, 1000, cores));
            cases.add(new Case(Kind.IR12, 1000, cores));
            cases.add(new Case(Kind.IR12, 4000, cores));
            cases.add(new Case(Kind.IR12, 10_000, cores));
        }
        return List.copyOf(cases);
    }

    @Override
    public List<String> names() {
        return CASES.stream().flatMap(c -> c.names().stream()).toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        for (Case one : CASES) {
            if (one.names().stream().anyMatch(assignment::wants)) {
                measure(one, assignment);
            }
        }
    }

    private void measure(Case one, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        ExecutorService helpers = Executors.newFixedThreadPool(
                Math.max(1, one.cores - 1),
                Thread.ofPlatform().daemon().name("bench-helper-", 1).factory());
        try (helpers;
                var swarm = new WanderingRobots(
                        cave(), one.kind, one.robots, SEED, one.cores == 1 ? Runnable::run : helpers)) {
            double seconds = warmUp(swarm);
            double[] rtf = new double[repeats];
            double[] cpu = new double[repeats];
            double[] rays = new double[repeats];
            double[] bytes = new double[repeats];
            for (int i = 0; i < repeats; i++) {
                long before = swarm.rays();
                var watch = new Stopwatch();
                swarm.advance(seconds);
                double wall = watch.wall();
                rtf[i] = seconds / wall;
                cpu[i] = seconds / watch.cpu();
                rays[i] = (swarm.rays() - before) / wall;
                bytes[i] = watch.bytes() / (seconds * STEPS_PER_SECOND * one.robots);
            }
            var reported = new ArrayList<>(List.of(
                    Result.more(one.name("rtf"), "s/s", rtf),
                    Result.more(one.name("cpu"), "s/s", cpu),
                    Result.more(one.name("rays"), "1/s", rays),
                    Result.less(one.name("bytes"), "B", bytes)));
            if (one.cores == 1 && assignment.wants(one.memory())) {
                reported.add(Result.less(one.memory(), "MB", Stopwatch.memory()));
            }
            assignment.report(reported);
        }
    }

    /// Seconds simulated per second of a processor, on one core.
    static double simulatedPerProcessorSecond(Kind kind, int robots) {
        try (var swarm = new WanderingRobots(Cave.draw(SIDE, RESOLUTION, SEED), kind, robots, SEED, Runnable::run)) {
            double seconds = warmUp(swarm);
            var watch = new Stopwatch();
            swarm.advance(seconds);
            return seconds / watch.cpu();
        }
    }

    /// Lets the machine learn the code.
    ///
    /// @return how much to simulate for a measurement that takes long enough [s]
    private static double warmUp(WanderingRobots swarm) {
        var sinceStart = new Stopwatch();
        double seconds = 0.5;
        double took = 0;
        while (sinceStart.cpu() < WARM || took < WORTH_MEASURING) {
            seconds = took < WORTH_MEASURING ? 2 * seconds : seconds;
            var watch = new Stopwatch();
            swarm.advance(seconds);
            took = watch.cpu();
        }
        return seconds;
    }

    private OccupancyGrid cave() {
        if (cave == null) {
            cave = Cave.draw(SIDE, RESOLUTION, SEED);
        }
        return cave;
    }
}
