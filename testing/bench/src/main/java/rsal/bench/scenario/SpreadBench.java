package rsal.bench.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.IntConsumer;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Bars.Bar;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.bench.place.Cave;
import rsal.bench.place.Office;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.navigation.spread.Evenness;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.spread.Spread;
import rsal.navigation.spread.Spreader;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// Places spread over a map, on one core, each repeat with random numbers of its own: beside the best of 100 of Lloyd's
/// runs from random places (the same 100 for all repeats).
///
/// Names are `spread.<map>.<places>.<what>`. What: `ratio`, root mean square of the way from anywhere to the nearest
/// place by the least of the 100; `mean.ratio`, the same of the mean; `ms`, time of the processor with all that is
/// looked at in the map.
public final class SpreadBench implements Bench {
    private static final int RUNS = 100;
    private static final int WARM = 3;
    private static final List<Integer> NUMBERS = List.of(3, 10, 20, 40);
    private static final List<String> WHATS = List.of("ratio", "mean.ratio", "ms");

    /// @param file among the public data; empty for what comes with the program
    /// @param clearance [m]
    private record Site(String label, String file, double clearance) {
        String name(int places, String what) {
            return "spread.%s.%d.%s".formatted(label, places, what);
        }

        boolean isWanted(BenchmarkRequest assignment) {
            return NUMBERS.stream()
                    .anyMatch(number -> WHATS.stream().anyMatch(what -> assignment.wants(name(number, what))));
        }

        Optional<OccupancyGrid> map(BenchmarkRequest assignment) {
            return switch (label) {
                case "office" -> Optional.of(Office.MAP);
                case "cave2560" -> Optional.of(Cave.draw(128, 0.05, 1));
                default -> assignment.data("maps/" + file).map(SpreadBench::read);
            };
        }
    }

    private static final List<Site> SITES = List.of(
            new Site("office", "", 0.3),
            new Site("office02", "mrpb_office02.yaml", 0.3),
            new Site("mall", "mrpb_shopping_mall.yaml", 0.3),
            new Site("warehouse", "nav2_warehouse.yaml", 0.3),
            new Site("tb3", "tb3_world.yaml", 0.1),
            new Site("cave2560", "", 0.3));

    private static OccupancyGrid read(Path file) {
        Path folder = Optional.ofNullable(file.getParent()).orElse(Path.of("."));
        return new Maps(FileSource.folder(folder))
                .read(String.valueOf(file.getFileName()), Location.of(file.toString()));
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        for (Site site : SITES) {
            for (int number : NUMBERS) {
                WHATS.forEach(what -> names.add(site.name(number, what)));
            }
        }
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var bars = new ArrayList<Bar>();
        for (Site site : SITES) {
            if (site.isWanted(assignment)) {
                site.map(assignment).ifPresent(map -> bars.addAll(measure(site, map, assignment)));
            }
        }
        assignment.show(new Plot.Bars(
                "Places spread over maps", "", "mean square root of paths, by the best of 100 of Lloyd's runs", bars));
    }

    private static List<Bar> measure(Site site, OccupancyGrid map, BenchmarkRequest assignment) {
        var bars = new ArrayList<Bar>();
        for (int number : NUMBERS) {
            boolean compared =
                    assignment.wants(site.name(number, "ratio")) || assignment.wants(site.name(number, "mean.ratio"));
            if (!compared && !assignment.wants(site.name(number, "ms"))) {
                continue;
            }
            var found = new ArrayList<Evenness>();
            assignment.report(
                    Result.less(site.name(number, "ms"), "ms", times(site, map, number, assignment.repeats(), found)));
            if (compared) {
                Evenness best = best(
                        new Spreader(ReachableSpace.largest(map, site.clearance), number),
                        done -> assignment.reach(site.name(number, "lloyd"), done, RUNS));
                var ratio = Result.less(
                        site.name(number, "ratio"),
                        "",
                        found.stream()
                                .mapToDouble(one -> one.rms() / best.rms())
                                .toArray());
                assignment.report(
                        ratio,
                        Result.less(
                                site.name(number, "mean.ratio"),
                                "",
                                found.stream()
                                        .mapToDouble(one -> one.mean() / best.mean())
                                        .toArray()));
                bars.add(new Bar(site.label, number + " places", ratio.value()));
            }
        }
        return bars;
    }

    /// @param found how even the places of each repeat are
    private static double[] times(Site site, OccupancyGrid map, int number, int repeats, List<Evenness> found) {
        var times = new double[repeats];
        for (int i = -WARM; i < repeats; i++) {
            var watch = new Stopwatch();
            var random = new SplittableRandom(Math.max(0, i) + 1L);
            Spread spread = new Spreader(ReachableSpace.largest(map, site.clearance), number).spread(random, _ -> {});
            if (i >= 0) {
                times[i] = watch.thread() * 1e3;
                found.add(spread.evenness());
            }
        }
        return times;
    }

    /// The least of each.
    ///
    /// @param done told how many runs are
    private static Evenness best(Spreader spreader, IntConsumer done) {
        double mean = Double.POSITIVE_INFINITY;
        double rms = Double.POSITIVE_INFINITY;
        double greatest = Double.POSITIVE_INFINITY;
        var random = new SplittableRandom(1);
        for (int run = 0; run < RUNS; run++) {
            Evenness one = spreader.lloyd(random).evenness();
            mean = Math.min(mean, one.mean());
            rms = Math.min(rms, one.rms());
            greatest = Math.min(greatest, one.greatest());
            done.accept(run + 1);
        }
        return new Evenness(mean, rms, greatest);
    }
}
