package rsal.bench.navigation;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.bench.measurement.AllCores;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Shares.Share;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.bench.navigation.BarnRun.Outcome;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.dwa.Dwa;
import rsal.navigation.mpc.Mpc;
import rsal.navigation.nd.Nd;
import rsal.navigation.snd.Snd;
import rsal.navigation.vfh.Vfh;

/// Local planners in the worlds of the BARN Challenge, each world once per repeat, on all cores. All are told only
/// where the goal is and what the laser sees.
///
/// Names are `barn.<planner>.<what>`. What, of all worlds: `success`, the share in which it arrived; `score`, the
/// mean of the challenge's score, at most 0.5; `touched`, the share in which it touched something; `ms`, time of the
/// processor per command; and of those in which it arrived: `seconds`, the mean time; `smoothness`, how much the
/// commanded turn rate changed [rad/s²], less is smoother. Runs that end nowhere, on the spot, say nothing about how
/// smoothly it drives.
///
/// Planners that arrive in different worlds can't be compared by that: `barn.smoother.<what>` is the smoothness of
/// `snd` by that of `nd`, of the worlds in which both arrive. What: `perSecond`, `perMeter`.
public final class BarnBench implements Bench {
    private static final double LOOKAHEAD = 3; // m
    private static final double WINDOW = 1.65; // m; half of that of VFH+ in its paper, 33 cells of 0.1 m

    private static final List<String> SMOOTHER = List.of("barn.smoother.perSecond", "barn.smoother.perMeter");

    private enum Avoidance {
        VFH,
        ND,
        SND,
        DWA,
        MPC;

        /// A planner of its own for each run.
        Controller planner() {
            var footprint = BarnRun.FOOTPRINT;
            var limits = BarnRun.LIMITS;
            double reaction = BarnRun.REACTION;
            return switch (this) {
                case VFH -> new Vfh(footprint, limits, Vfh.Settings.of(WINDOW, 0.1, 0.3), reaction);
                case ND -> new Nd(footprint, limits, Nd.Settings.DEFAULT, reaction);
                case SND -> new Snd(footprint, limits, Snd.Settings.of(footprint), reaction);
                case DWA -> new Dwa(footprint, limits, Dwa.Settings.of(0.25, LOOKAHEAD), reaction);
                case MPC -> new Mpc(footprint, limits, Mpc.Settings.DEFAULT, reaction, BarnRun.BEAT);
            };
        }

        String name(What what) {
            return "barn.%s.%s".formatted(lower(this), lower(what));
        }
    }

    private enum What {
        SUCCESS,
        SCORE,
        TOUCHED,
        MS,
        SECONDS,
        SMOOTHNESS;

        double of(List<Run> runs) {
            return switch (this) {
                case SUCCESS -> mean(runs, run -> run.outcome().reached() ? 1 : 0);
                case SCORE ->
                    mean(
                            runs,
                            run -> run.outcome().reached()
                                    ? run.world().score(run.outcome().seconds())
                                    : 0);
                case TOUCHED -> mean(runs, run -> run.outcome().touched() ? 1 : 0);
                case MS -> mean(runs, Run::milliseconds);
                case SECONDS -> mean(reached(runs), run -> run.outcome().seconds());
                case SMOOTHNESS -> mean(reached(runs), run -> run.outcome().roughness());
            };
        }

        Result result(String name, double... values) {
            return switch (this) {
                case SUCCESS, SCORE -> Result.more(name, "", values);
                case TOUCHED -> Result.less(name, "", values);
                case MS -> Result.less(name, "ms", values);
                case SECONDS -> Result.less(name, "s", values);
                case SMOOTHNESS -> Result.less(name, "rad/s²", values);
            };
        }
    }

    /// @param milliseconds of the processor per command
    private record Run(BarnWorld world, Outcome outcome, double milliseconds) {}

    /// Notes how long another planner takes.
    private static final class Timed implements Controller {
        private final Controller planner;
        private double seconds;
        private int drives;

        Timed(Controller planner) {
            this.planner = planner;
        }

        double milliseconds() {
            return 1e3 * seconds / drives;
        }

        @Override
        public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
            var watch = new Stopwatch();
            Twist2d command = planner.drive(obstacles, target, motion);
            seconds += watch.thread();
            drives++;
            return command;
        }

        @Override
        public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
            return planner.turn(obstacles, angle, motion);
        }

        @Override
        public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
            return planner.guarded(obstacles, wanted, motion);
        }

        @Override
        public void reset() {
            planner.reset();
        }
    }

    private static String lower(Enum<?> value) {
        return value.name().toLowerCase(java.util.Locale.ROOT);
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        for (Avoidance avoidance : Avoidance.values()) {
            for (What what : What.values()) {
                names.add(avoidance.name(what));
            }
        }
        names.addAll(SMOOTHER);
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        Optional<Path> file = assignment.data("barn/worlds.json");
        if (file.isEmpty()) {
            return;
        }
        List<BarnWorld> worlds;
        try {
            worlds = BarnWorld.read(file.get());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        boolean compared = SMOOTHER.stream().anyMatch(assignment::wants);
        var measured = new EnumMap<Avoidance, List<List<Run>>>(Avoidance.class);
        for (Avoidance avoidance : Avoidance.values()) {
            boolean wanted = Stream.of(What.values()).anyMatch(what -> assignment.wants(avoidance.name(what)));
            if (wanted || (compared && (avoidance == Avoidance.ND || avoidance == Avoidance.SND))) {
                measured.put(avoidance, measure(avoidance, worlds, assignment));
            }
        }
        if (compared) {
            compare(
                    measured.getOrDefault(Avoidance.SND, List.of()),
                    measured.getOrDefault(Avoidance.ND, List.of()),
                    assignment);
        }
        if (!measured.isEmpty()) {
            assignment.show(successes(measured));
        }
    }

    private static List<List<Run>> measure(Avoidance avoidance, List<BarnWorld> worlds, BenchmarkRequest assignment) {
        var repeats = new ArrayList<List<Run>>();
        for (int repeat = 0; repeat < assignment.repeats(); repeat++) {
            repeats.add(runs(avoidance, worlds, repeat, assignment));
        }
        for (What what : What.values()) {
            double[] values = repeats.stream().mapToDouble(what::of).toArray();
            assignment.report(what.result(avoidance.name(what), values));
        }
        return repeats;
    }

    /// How much less the turn rate changes, in worlds that both came through with the same noise.
    private static void compare(List<List<Run>> snd, List<List<Run>> nd, BenchmarkRequest assignment) {
        double[] perSecond = new double[snd.size()];
        double[] perMeter = new double[snd.size()];
        for (int repeat = 0; repeat < perSecond.length; repeat++) {
            List<Run> first = snd.get(repeat);
            List<Run> second = nd.get(repeat);
            List<Integer> both = IntStream.range(0, first.size())
                    .filter(i -> first.get(i).outcome().reached()
                            && second.get(i).outcome().reached())
                    .boxed()
                    .toList();
            perSecond[repeat] = ratio(
                    both,
                    i -> first.get(i).outcome().roughness(),
                    i -> second.get(i).outcome().roughness());
            perMeter[repeat] = ratio(
                    both,
                    i -> perMeter(first.get(i).outcome()),
                    i -> perMeter(second.get(i).outcome()));
        }
        assignment.report(
                Result.less(SMOOTHER.getFirst(), "", perSecond), Result.less(SMOOTHER.getLast(), "", perMeter));
    }

    private static double ratio(List<Integer> of, ToDoubleFunction<Integer> one, ToDoubleFunction<Integer> other) {
        return of.stream().mapToDouble(one).sum()
                / of.stream().mapToDouble(other).sum();
    }

    private static double perMeter(Outcome outcome) {
        return outcome.roughness() * outcome.seconds() / outcome.meters();
    }

    private static Plot successes(Map<Avoidance, List<List<Run>>> measured) {
        var shares = new ArrayList<Share>();
        measured.forEach((avoidance, repeats) -> {
            for (int i = 0; i < repeats.getFirst().size(); i++) {
                int world = i;
                double share = repeats.stream()
                        .mapToDouble(runs -> runs.get(world).outcome().reached() ? 1 : 0)
                        .average()
                        .orElseThrow();
                String number =
                        Integer.toString(repeats.getFirst().get(i).world().number());
                shares.add(new Share(lower(avoidance), number, share));
            }
        });
        return new Plot.Shares("Worlds of the BARN Challenge that are passed", "world", "", "share of runs", shares);
    }

    private static List<Run> reached(List<Run> runs) {
        return runs.stream().filter(run -> run.outcome().reached()).toList();
    }

    private static double mean(List<Run> runs, ToDoubleFunction<Run> value) {
        return runs.stream().mapToDouble(value).average().orElse(0);
    }

    private static List<Run> runs(
            Avoidance avoidance, List<BarnWorld> worlds, int repeat, BenchmarkRequest assignment) {
        return AllCores.each(
                "barn",
                worlds,
                world -> {
                    var planner = new Timed(avoidance.planner());
                    Outcome outcome = new BarnRun(world, planner, 1000L * repeat + world.number()).run();
                    return new Run(world, outcome, planner.milliseconds());
                },
                done -> assignment.reach(
                        "barn.%s, worlds".formatted(lower(avoidance)),
                        repeat * worlds.size() + done,
                        assignment.repeats() * worlds.size()));
    }
}
