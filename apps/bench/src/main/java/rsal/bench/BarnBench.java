package rsal.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.ToDoubleFunction;
import rsal.bench.BarnRun.Outcome;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.dwa.Dwa;
import rsal.navigation.mpc.Mpc;
import rsal.navigation.nd.Nd;
import rsal.navigation.snd.Snd;
import rsal.navigation.vfh.Vfh;

/// Local planners in the worlds of the BARN Challenge, each world once per repeat, on all cores. All are told only
/// where the goal is and what the laser sees.
///
/// Names are `barn.<planner>.<what>`. What, of all worlds: `success`, the share in which it arrived; `score`, the
/// mean of the challenge's score, at most 0.5; `touched`, the share in which it touched something; and of those in
/// which it arrived: `seconds`, the mean time; `smoothness`, how much the commanded turn rate changed [rad/s²], less
/// is smoother. Runs that end nowhere, on the spot, say nothing about how smoothly it drives.
final class BarnBench implements Bench {
    private static final double LOOKAHEAD = 3; // m
    private static final double WINDOW = 1.65; // m; half of that of VFH+ in its paper, 33 cells of 0.1 m

    private enum Avoidance {
        VFH,
        ND,
        SND,
        DWA,
        MPC;

        /// A planner of its own for each run.
        LocalPlanner planner() {
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
                case SECONDS -> mean(reached(runs), run -> run.outcome().seconds());
                case SMOOTHNESS -> mean(reached(runs), run -> run.outcome().roughness());
            };
        }

        Result result(String name, double... values) {
            return switch (this) {
                case SUCCESS, SCORE -> Result.more(name, "", values);
                case TOUCHED -> Result.less(name, "", values);
                case SECONDS -> Result.less(name, "s", values);
                case SMOOTHNESS -> Result.less(name, "rad/s²", values);
            };
        }
    }

    private record Run(BarnWorld world, Outcome outcome) {}

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
        return names;
    }

    @Override
    public void measure(Assignment assignment) {
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
        for (Avoidance avoidance : Avoidance.values()) {
            boolean wanted = List.of(What.values()).stream().anyMatch(what -> assignment.wants(avoidance.name(what)));
            if (wanted) {
                measure(avoidance, worlds, assignment);
            }
        }
    }

    private static void measure(Avoidance avoidance, List<BarnWorld> worlds, Assignment assignment) {
        var repeats = new ArrayList<List<Run>>();
        for (int repeat = 0; repeat < assignment.repeats(); repeat++) {
            repeats.add(runs(avoidance, worlds, repeat));
        }
        for (What what : What.values()) {
            double[] values = repeats.stream().mapToDouble(what::of).toArray();
            assignment.tell(what.result(avoidance.name(what), values));
        }
    }

    private static List<Run> reached(List<Run> runs) {
        return runs.stream().filter(run -> run.outcome().reached()).toList();
    }

    private static double mean(List<Run> runs, ToDoubleFunction<Run> value) {
        return runs.stream().mapToDouble(value).average().orElse(0);
    }

    private static List<Run> runs(Avoidance avoidance, List<BarnWorld> worlds, int repeat) {
        int cores = Runtime.getRuntime().availableProcessors();
        try (var workers = Executors.newFixedThreadPool(
                cores, Thread.ofPlatform().daemon().name("barn-", 1).factory())) {
            var futures = new ArrayList<Future<Run>>();
            for (BarnWorld world : worlds) {
                long seed = 1000L * repeat + world.number();
                futures.add(workers.submit(() -> new Run(world, new BarnRun(world, avoidance.planner(), seed).run())));
            }
            var runs = new ArrayList<Run>();
            for (Future<Run> future : futures) {
                runs.add(future.get());
            }
            return runs;
        } catch (ExecutionException e) {
            throw new IllegalStateException("A run failed.", e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("Measuring was interrupted.", e);
        }
    }
}
