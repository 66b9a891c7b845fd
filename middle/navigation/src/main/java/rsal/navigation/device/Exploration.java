package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.explore.Division;
import rsal.navigation.explore.Frontier;
import rsal.navigation.explore.Frontiers;
import rsal.navigation.explore.Trodden;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.NavigationFunction;
import rsal.navigation.wavefront.Wavefront;
import rsal.time.Scheduler;

/// Robots that explore together: draws one map of all they saw, and tells each where to go. They must know
/// where they start, in one frame, or each explores alone.
///
/// Looks again every few seconds. A place that stays a frontier though a robot was there, or that can't be
/// reached, is left alone.
final class Exploration {
    static final Duration PERIOD = Duration.ofSeconds(3);
    private static final double SLACK = 1.2; // m; from a frontier to where a robot can stand
    private static final double SAME = 0.7; // m; frontiers whose places are nearer are one
    private static final double LOYALTY = 2; // m of way that going on is cheaper than turning back

    private final Settings settings;
    private final List<Explorer> robots = new ArrayList<>();
    private final List<Point2d> leftAlone = new ArrayList<>();
    private Instant lastLook = Instant.MIN;
    private boolean looking;

    /// @param resolution of the map [m]
    /// @param shortest frontiers below are left out [m]
    /// @param view how far robots see [m]
    /// @param bodyRadius of the circle that robots turn in [m]
    /// @param clearance that ways keep
    record Settings(double resolution, double shortest, double view, double bodyRadius, CostMap.Clearance clearance) {}

    /// What a robot is to do on a map; nothing when it has no goal.
    record Order(OccupancyGrid map, Wavefront ways, DistanceField toNotFree, Optional<Goal> goal) {}

    /// @param stand where it can be
    /// @param frontier that it is for
    record Goal(Point2d stand, Point2d frontier) {}

    private record Reach(Point2d stand, double cost) {
        static Reach none(Point2d place) {
            return new Reach(place, Double.POSITIVE_INFINITY);
        }
    }

    Exploration(Settings settings) {
        this.settings = settings;
    }

    void join(Explorer robot) {
        robots.add(robot);
    }

    /// Doesn't send anyone to a frontier again.
    void leaveAlone(Point2d frontier) {
        leftAlone.add(frontier);
    }

    /// Called by each robot of the team, as any of them may leave the run; the first one counts. One look at a time:
    /// the next waits until what the last one found is told.
    void look(Scheduler scheduler) {
        if (looking || lastLook.plus(PERIOD).isAfter(scheduler.instant())) {
            return;
        }
        lastLook = scheduler.instant();
        List<Explorer> ready = robots.stream().filter(Explorer::ready).toList();
        List<PosedScan> seen = robots.stream().flatMap(r -> r.seen().stream()).toList();
        if (ready.isEmpty() || seen.isEmpty()) {
            return;
        }
        List<Point2d> places = ready.stream().map(Explorer::place).toList();
        List<Optional<Point2d>> goals = ready.stream().map(Explorer::frontier).toList();
        List<Point2d> alone = List.copyOf(leftAlone);
        looking = true;
        scheduler.compute(() -> orders(seen, places, goals, alone)).whenComplete((orders, error) -> {
            looking = false;
            for (int i = 0; i < ready.size(); i++) {
                if (error != null) {
                    ready.get(i).fail(error);
                } else {
                    ready.get(i).take(orders.get(i));
                }
            }
        });
    }

    private List<Order> orders(
            List<PosedScan> seen, List<Point2d> places, List<Optional<Point2d>> goals, List<Point2d> alone) {
        double view = settings.view();
        OccupancyGrid drawn = ScanMapper.draw(
                seen, ScanMapper.Settings.of(settings.resolution()).upTo(view, view));
        OccupancyGrid map = Trodden.free(drawn, trodden(seen, places), room());
        DistanceField toNotFree = DistanceField.toNotFree(map);
        var ways = new Wavefront(CostMap.of(map, toNotFree, settings.clearance()));
        List<Frontier> frontiers = Frontiers.of(map, settings.shortest()).stream()
                .filter(f -> alone.stream().noneMatch(place -> place.distanceTo(f.place()) < SAME))
                .toList();
        var reaches = new Reach[places.size()][frontiers.size()];
        var costs = new double[places.size()][frontiers.size()];
        for (int robot = 0; robot < places.size(); robot++) {
            Optional<NavigationFunction> from = ways.everywhere(places.get(robot), SLACK);
            for (int i = 0; i < frontiers.size(); i++) {
                Point2d place = frontiers.get(i).place();
                Reach reach = from.map(f -> reach(map, f, place)).orElse(Reach.none(place));
                reaches[robot][i] = reach;
                boolean going = goals.get(robot)
                        .filter(goal -> goal.distanceTo(place) < SAME)
                        .isPresent();
                costs[robot][i] = reach.cost() - (going ? LOYALTY : 0);
            }
        }
        List<Optional<Integer>> chosen = Division.assign(frontiers, costs, view);
        var orders = new ArrayList<Order>();
        for (int robot = 0; robot < places.size(); robot++) {
            Reach[] own = reaches[robot];
            orders.add(new Order(
                    map,
                    ways,
                    toNotFree,
                    chosen.get(robot)
                            .map(i -> new Goal(own[i].stand(), frontiers.get(i).place()))));
        }
        return orders;
    }

    private static List<Point2d> trodden(List<PosedScan> seen, List<Point2d> places) {
        return Stream.concat(seen.stream().map(scan -> scan.mapFromBase().position()), places.stream())
                .toList();
    }

    /// That a robot has for sure where it stands: to turn, and to be on its way at all.
    private double room() {
        return Math.max(settings.bodyRadius(), settings.clearance().radius()) + settings.resolution();
    }

    /// The nearest place to a frontier where the robot can get.
    private static Reach reach(OccupancyGrid map, NavigationFunction from, Point2d frontier) {
        int cells = (int) (SLACK / map.resolution());
        int column = map.column(frontier.x());
        int row = map.row(frontier.y());
        Reach best = Reach.none(frontier);
        double nearest = SLACK;
        for (int r = Math.max(0, row - cells); r <= Math.min(map.height() - 1, row + cells); r++) {
            for (int c = Math.max(0, column - cells); c <= Math.min(map.width() - 1, column + cells); c++) {
                var stand = new Point2d(map.x(c), map.y(r));
                double distance = stand.distanceTo(frontier);
                if (distance < nearest) {
                    double cost = from.cost(stand);
                    if (cost < Double.POSITIVE_INFINITY) {
                        best = new Reach(stand, cost);
                        nearest = distance;
                    }
                }
            }
        }
        return best;
    }
}
