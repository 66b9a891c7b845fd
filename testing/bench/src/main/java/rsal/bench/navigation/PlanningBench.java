package rsal.bench.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Plot.Bars.Bar;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.bench.place.Cave;
import rsal.bench.place.Floor;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.navigation.grid.Difference;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.jumppoint.JumpPoints;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;

/// Planning ways over large maps, on one core: a cave of 2560 × 2560 cells of 0.05 m and a floor like that of a
/// hospital of 3117 × 1189, for a robot of 0.5 m. Times are those of the processor.
///
/// Names are `wavefront.<map>.<what>ms`. What: nothing, a way between two places that were not asked for before;
/// `full.`, what the way costs from everywhere; `again.`, from another place to the same goal; `around.`, the same
/// around something in the middle of the way that is not on the map; `costs.`, where the robot can be and how dear it
/// is; `mended.`, costs and a plan to a goal that is kept when something has just come onto the map or gone from it 3 m
/// ahead of the robot, in place of `costs.` and `full.`; `mended.costs.`, the costs of that; `mended.halfway.`, in the
/// middle of the way, `mended.goal.`, 3 m before the goal; `shortest.`, a shortest way by jump points.
public final class PlanningBench implements Bench {
    private static final Clearance CLEARANCE = new Clearance(0.25, 0.6, 3); // [m]
    private static final double SLACK = 0.5; // [m]
    private static final double WARM = 3; // [s]
    private static final int PLANS = 10; // of a measurement
    private static final int FRESH = 300; // goals; that many later nobody remembers one
    private static final double AHEAD = 3; // [m]
    private static final int BOX = 5; // cells from the middle to the sides of what comes onto the map
    private static final List<String> KINDS = List.of(
            "",
            "full.",
            "again.",
            "around.",
            "costs.",
            "mended.",
            "mended.halfway.",
            "mended.goal.",
            "mended.costs.",
            "shortest.");

    private enum Site {
        CAVE2560,
        HOSPITAL;

        OccupancyGrid map() {
            return this == CAVE2560 ? Cave.draw(128, 0.05, 1) : Floor.draw(3117, 1189, 0.05, 1);
        }

        String label() {
            return name().toLowerCase(Locale.ROOT);
        }

        String name(String kind) {
            return "wavefront.%s.%sms".formatted(label(), kind);
        }
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<String>();
        for (Site site : Site.values()) {
            KINDS.forEach(kind -> names.add(site.name(kind)));
        }
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        var bars = new ArrayList<Bar>();
        for (Site site : Site.values()) {
            if (KINDS.stream().anyMatch(kind -> assignment.wants(site.name(kind)))) {
                bars.addAll(measure(site, assignment));
            }
        }
        assignment.show(new Plot.Bars("Planning", "", "time of the processor [ms]", bars));
    }

    private static List<Bar> measure(Site site, BenchmarkRequest assignment) {
        var bars = new ArrayList<Bar>();
        OccupancyGrid map = site.map();
        var random = new SplittableRandom(1);
        DistanceField toNotFree = DistanceField.toNotFree(map);
        CostMap costs = CostMap.of(map, toNotFree, CLEARANCE);
        Wavefront wavefront = new Wavefront(costs);
        var jumps = new JumpPoints(costs);
        List<Point2d> places = places(costs, random);
        Point2d goal = places.getFirst();
        for (Point2d start : places.subList(1, 1 + PLANS)) {
            found(wavefront.plan(start, goal, SLACK)); // so that it is kept, whatever is measured first
        }
        Plan.Found plan = (Plan.Found) wavefront.plan(places.get(1), goal, SLACK);
        Known known = new Known(toNotFree, wavefront);
        Known nothingKept = new Known(toNotFree, new Wavefront(costs));
        Consumer<Wavefront> replan = now -> found(now.plan(places.get(1), goal, SLACK));
        Point2d obstructing = plan.path().points().get(plan.path().points().size() / 2);
        for (String kind : KINDS) {
            if (!assignment.wants(site.name(kind))) {
                continue;
            }
            IntConsumer job = switch (kind) {
                case "full." -> _ -> check(wavefront.everywhere(goal, SLACK).isPresent());
                case "again." -> i -> found(wavefront.plan(places.get(1 + i % PLANS), goal, SLACK));
                case "mended." -> changing(known, withBox(map, along(plan.path(), AHEAD)), replan);
                case "mended.halfway." -> changing(known, withBox(map, obstructing), replan);
                case "mended.goal." ->
                    changing(known, withBox(map, along(plan.path(), plan.path().length() - AHEAD)), replan);
                case "mended.costs." -> changing(nothingKept, withBox(map, along(plan.path(), AHEAD)), _ -> {});
                case "around." -> _ -> found(wavefront.plan(places.get(1), goal, SLACK, List.of(obstructing)));
                case "shortest." -> i -> found(jumps.plan(places.get(1 + i % PLANS), goal, SLACK));
                case "costs." -> _ -> CostMap.of(map, DistanceField.toNotFree(map), CLEARANCE);
                default -> i -> found(wavefront.plan(places.get(1 + i % PLANS), places.get(20 + i % FRESH), SLACK));
            };
            var result = Result.less(site.name(kind), "ms", times(job, assignment.repeats()));
            assignment.report(result);
            bars.add(new Bar(
                    site.label(),
                    kind.isEmpty() ? "first" : kind.replace(".", " ").strip(),
                    result.value()));
        }
        return bars;
    }

    /// @param distance from its start [m]
    private static Point2d along(Path2d path, double distance) {
        double left = distance;
        for (int i = 1; i < path.points().size(); i++) {
            Point2d from = path.points().get(i - 1);
            Point2d to = path.points().get(i);
            double length = from.distanceTo(to);
            if (left <= length) {
                double share = left / length;
                return new Point2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
            }
            left -= length;
        }
        throw new IllegalStateException("The path is too short.");
    }

    /// What is known of a map.
    private record Known(DistanceField toNotFree, Wavefront wavefront) {
        OccupancyGrid map() {
            return wavefront.map().grid();
        }

        /// The same of another that differs little.
        Known over(OccupancyGrid next) {
            Difference difference = Difference.between(map(), next).orElseThrow();
            DistanceField toNotFreeNext = DistanceField.toNotFree(difference, toNotFree);
            return new Known(toNotFreeNext, wavefront.over(wavefront.map().over(difference, toNotFreeNext)));
        }
    }

    /// Does something while something else comes onto the map and goes.
    private static IntConsumer changing(Known first, OccupancyGrid other, Consumer<Wavefront> then) {
        var now = new AtomicReference<>(first);
        return i -> {
            Known next = now.get().over(i % 2 == 0 ? other : first.map());
            then.accept(next.wavefront());
            now.set(next);
        };
    }

    private static OccupancyGrid withBox(OccupancyGrid map, Point2d middle) {
        byte[] cells = map.cells().clone();
        for (int row = map.row(middle.y()) - BOX; row <= map.row(middle.y()) + BOX; row++) {
            for (int column = map.column(middle.x()) - BOX; column <= map.column(middle.x()) + BOX; column++) {
                if (map.contains(column, row)) {
                    cells[row * map.width() + column] = OccupancyGrid.OCCUPIED;
                }
            }
        }
        return new OccupancyGrid(map.width(), map.height(), map.resolution(), map.originX(), map.originY(), cells);
    }

    private static double[] times(IntConsumer job, int repeats) {
        var warm = new Stopwatch();
        int number = 0;
        while (warm.cpu() < WARM) {
            job.accept(number++);
        }
        double[] times = new double[repeats];
        for (int repeat = 0; repeat < repeats; repeat++) {
            var watch = new Stopwatch();
            for (int i = 0; i < PLANS; i++) {
                job.accept(number++);
            }
            times[repeat] = watch.thread() / PLANS * 1e3;
        }
        return times;
    }

    /// Places between which there is a way.
    private static List<Point2d> places(CostMap costs, SplittableRandom random) {
        OccupancyGrid grid = costs.grid();
        var wavefront = new Wavefront(costs);
        var anywhere = new ArrayList<Point2d>();
        while (anywhere.size() < 2 * FRESH) {
            var place = new Point2d(
                    grid.originX() + random.nextDouble() * grid.width() * grid.resolution(),
                    grid.originY() + random.nextDouble() * grid.height() * grid.resolution());
            if (costs.isPassable(place)) {
                anywhere.add(place);
            }
        }
        List<Point2d> best = List.of();
        for (Point2d goal : anywhere.subList(0, 5)) {
            var function = wavefront.everywhere(goal, SLACK).orElseThrow();
            var reached = new ArrayList<>(List.of(goal));
            anywhere.stream()
                    .filter(place -> !place.equals(goal) && Double.isFinite(function.cost(place)))
                    .forEach(reached::add);
            best = reached.size() > best.size() ? reached : best;
        }
        return best;
    }

    private static void found(Plan plan) {
        check(plan instanceof Plan.Found);
    }

    private static void check(boolean found) {
        if (!found) {
            throw new IllegalStateException("There was a path before.");
        }
    }
}
