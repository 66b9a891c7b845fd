package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Mapper;
import rsal.navigation.explore.Frontier;
import rsal.navigation.explore.FrontierAssignment;
import rsal.navigation.explore.Frontiers;
import rsal.navigation.explore.VisitedCells;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.IncrementalMap;
import rsal.navigation.grid.ScanMapper;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.NavigationFunction;
import rsal.navigation.wavefront.Wavefront;
import rsal.time.Scheduler;

/// Robots that explore together: draws one map of all they saw, and tells each where to go. They must know
/// where they start, in one frame, or each explores alone. They tell each other where they are, so that none takes
/// another for a wall.
///
/// Looks again every few seconds. A place that stays a frontier though a robot was there, or that can't be
/// reached, is left alone ([LeftAlone]). When nothing else is left, a robot goes where one of its size has been, so
/// that none is shut in by a door that the map's cells make narrower than it is. Each robot is sent where its own body
/// fits; how the map is drawn, the first of a team says for all.
final class Exploration {
    static final Duration PERIOD = Duration.ofSeconds(3);
    private static final double SLACK = 1.2; // m; from a frontier to where a robot can stand
    private static final double LOST_TO_CELLS = 1.5; // beside a way: the wall's cell, and half of that in its middle
    private static final double LOYALTY = 2; // m of way that going on is cheaper than turning back

    private final Settings settings;
    private final List<Explorer> robots = new ArrayList<>();
    private final LeftAlone leftAlone = new LeftAlone();
    private final Sequence sequence = new Sequence(); // only the look under way touches it
    private final IncrementalMap drawing; // only the look under way touches it
    private @Nullable Terrain terrain; // the last one; only the look under way touches it
    private Instant lastLook = Instant.MIN;
    private boolean looking;

    /// @param resolution of the map [m]
    /// @param shortest frontiers below are left out [m]
    /// @param view how far robots see [m]
    record Settings(double resolution, double shortest, double view) {}

    /// How much room a robot needs.
    ///
    /// @param radius of the circle that it turns in [m]
    /// @param clearance that its ways keep
    record Body(double radius, CostMap.Clearance clearance) {
        /// What it has for sure where it stands: to turn, and to be on its way at all.
        private double room(double resolution) {
            return Math.max(radius, clearance.radius()) + resolution;
        }
    }

    /// What a robot saw from where it was.
    record Seen(Body body, List<PosedScan> scans) {
        private List<Point2d> places() {
            return scans.stream().map(scan -> scan.mapFromBase().position()).toList();
        }
    }

    /// A robot that knows where it is.
    ///
    /// @param frontier to which it is on its way
    /// @param goes whether it is to be sent somewhere
    record Ready(Body body, Point2d place, Optional<Point2d> frontier, boolean goes) {}

    /// What a robot is to do on a map; nothing when it has no goal.
    ///
    /// @param ends of the map that it can get to, also those that another one has taken
    /// @param complete whether it is sure that there are none
    /// @param narrow ends of the map that it could get to if ways there were wider by up to three cells; looked for
    /// when there are no others
    record Order(
            OccupancyGrid map,
            Wavefront wavefront,
            DistanceField toNotFree,
            Optional<Goal> goal,
            List<Mapper.End> ends,
            boolean complete,
            List<Point2d> narrow) {}

    /// @param stand where it can be
    /// @param frontier that it is for
    record Goal(Point2d stand, Point2d frontier) {
        /// At the stand, looking at the frontier.
        Pose2d mapFromStand() {
            double towards = Math.atan2(frontier.y() - stand.y(), frontier.x() - stand.x());
            return new Pose2d(stand.x(), stand.y(), towards);
        }
    }

    private record Reach(Point2d stand, double cost) {
        static Reach none(Point2d place) {
            return new Reach(place, Double.POSITIVE_INFINITY);
        }
    }

    Exploration(Settings settings) {
        this.settings = settings;
        this.drawing = new IncrementalMap(
                ScanMapper.Settings.of(settings.resolution()).upTo(settings.view(), settings.view()));
    }

    void join(Explorer robot) {
        robots.add(robot);
    }

    /// Where a robot's mates are that know it.
    List<Mate> mates(Explorer robot) {
        return robots.stream()
                .filter(other -> !other.equals(robot) && other.ready())
                .map(other -> new Mate(other.place(), other.body().radius()))
                .toList();
    }

    /// Doesn't send anyone to a frontier for now.
    void leaveAlone(Point2d frontier, Instant now) {
        leftAlone.add(frontier, now);
    }

    /// Called by each robot of the team, as any of them may leave the run; the first one counts. One look at a time:
    /// the next waits until what the last one found is told.
    void look(Scheduler scheduler) {
        if (looking || lastLook.plus(PERIOD).isAfter(scheduler.instant())) {
            return;
        }
        lastLook = scheduler.instant();
        List<Explorer> ready = robots.stream().filter(Explorer::ready).toList();
        List<Seen> seen = robots.stream().map(r -> new Seen(r.body(), r.seen())).toList();
        leftAlone.follow(seen.stream().map(Seen::scans).toList());
        if (ready.isEmpty() || seen.stream().allMatch(s -> s.scans().isEmpty())) {
            return;
        }
        List<Ready> sent = ready.stream()
                .map(r -> new Ready(r.body(), r.place(), r.frontier(), !r.paused()))
                .toList();
        List<Point2d> alone = leftAlone.at(scheduler.instant());
        looking = true;
        scheduler.compute(() -> orders(seen, sent, alone)).whenComplete((orders, error) -> {
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

    /// @param alone frontiers to which nobody is sent
    /// @return by robot that is ready
    List<Order> orders(List<Seen> seen, List<Ready> ready, List<Point2d> alone) {
        OccupancyGrid map = map(seen, ready);
        Terrain now = Terrain.of(map, terrain);
        terrain = now;
        List<Frontier> frontiers = Frontiers.of(map, settings.shortest()).stream()
                .filter(f -> alone.stream().noneMatch(place -> LeftAlone.isSame(place, f.place())))
                .toList();
        var openWhereDriven = new HashMap<CostMap.Clearance, Wavefront>();
        var founds = new ArrayList<Found>();
        var costs = new double[ready.size()][frontiers.size()];
        for (int robot = 0; robot < ready.size(); robot++) {
            Ready one = ready.get(robot);
            CostMap.Clearance room = one.body().clearance();
            Found found = Found.by(now.wavefront(room), one.place(), frontiers);
            if (found.leadsNowhere() && !frontiers.isEmpty()) {
                Wavefront back = openWhereDriven.computeIfAbsent(
                        room, c -> new Wavefront(CostMap.of(map, now.toNotFree(), c, driven(seen, c))));
                Found further = Found.by(back, one.place(), frontiers);
                found = further.leadsNowhere() ? found : further;
            }
            founds.add(found);
            for (int i = 0; i < frontiers.size(); i++) {
                Point2d place = frontiers.get(i).place();
                boolean going = one.frontier()
                        .filter(goal -> LeftAlone.isSame(goal, place))
                        .isPresent();
                costs[robot][i] =
                        one.goes() ? found.reaches().get(i).cost() - (going ? LOYALTY : 0) : Double.POSITIVE_INFINITY;
            }
        }
        List<Optional<Integer>> chosen = FrontierAssignment.assign(frontiers, costs, settings.view());
        var orders = new ArrayList<Order>();
        for (int robot = 0; robot < ready.size(); robot++) {
            Found found = founds.get(robot);
            boolean complete = found.leadsNowhere();
            orders.add(new Order(
                    map,
                    found.wavefront(),
                    now.toNotFree(),
                    chosen.get(robot)
                            .map(i -> new Goal(
                                    found.reaches().get(i).stand(),
                                    frontiers.get(i).place())),
                    ends(frontiers, found.reaches()),
                    complete,
                    complete ? narrow(now, ready.get(robot), frontiers) : List.of()));
        }
        return orders;
    }

    /// How a robot gets to frontiers.
    ///
    /// @param known whether it knows what it can get to
    /// @param reaches of each frontier
    private record Found(Wavefront wavefront, boolean known, List<Reach> reaches) {
        static Found by(Wavefront wavefront, Point2d place, List<Frontier> frontiers) {
            Optional<NavigationFunction> from = wavefront.everywhere(place, SLACK);
            OccupancyGrid map = wavefront.map().grid();
            List<Reach> reaches = frontiers.stream()
                    .map(Frontier::place)
                    .map(end -> from.map(f -> reach(map, f, end)).orElse(Reach.none(end)))
                    .toList();
            return new Found(wavefront, from.isPresent(), reaches);
        }

        /// Whether it is sure that it can get to none.
        boolean leadsNowhere() {
            return known && reaches.stream().allMatch(reach -> reach.cost() == Double.POSITIVE_INFINITY);
        }
    }

    /// Where those were that need no less room.
    private static List<List<Point2d>> driven(List<Seen> seen, CostMap.Clearance clearance) {
        return seen.stream()
                .filter(robot -> robot.body().clearance().radius() >= clearance.radius())
                .map(Seen::places)
                .toList();
    }

    /// Paths may be wider than their cells by so much on either side.
    private static List<Point2d> narrow(Terrain terrain, Ready robot, List<Frontier> frontiers) {
        if (frontiers.isEmpty()) {
            return List.of();
        }
        OccupancyGrid map = terrain.map();
        var kept = robot.body().clearance();
        double radius = Math.max(0, kept.radius() - LOST_TO_CELLS * map.resolution());
        var less = new CostMap.Clearance(radius, kept.comfort(), kept.weight());
        return new Wavefront(CostMap.of(map, terrain.toNotFree(), less))
                .everywhere(robot.place(), SLACK).stream()
                        .flatMap(from -> frontiers.stream()
                                .map(Frontier::place)
                                .filter(place -> reach(map, from, place).cost() < Double.POSITIVE_INFINITY))
                        .toList();
    }

    /// @param reaches of one robot, by frontier
    private static List<Mapper.End> ends(List<Frontier> frontiers, List<Reach> reaches) {
        var ends = new ArrayList<Mapper.End>();
        for (int i = 0; i < reaches.size(); i++) {
            if (reaches.get(i).cost() < Double.POSITIVE_INFINITY) {
                Frontier frontier = frontiers.get(i);
                var goal = new Goal(reaches.get(i).stand(), frontier.place());
                ends.add(new Mapper.End(
                        frontier.place(),
                        goal.mapFromStand(),
                        frontier.length(),
                        reaches.get(i).cost()));
            }
        }
        return List.copyOf(ends);
    }

    private OccupancyGrid map(List<Seen> seen, List<Ready> ready) {
        OccupancyGrid map =
                drawing.of(sequence.of(seen.stream().map(Seen::scans).toList()));
        var trodden = new LinkedHashMap<Double, List<Point2d>>(); // by room
        for (Seen robot : seen) {
            robot.scans()
                    .forEach(scan -> trodden.computeIfAbsent(
                                    robot.body().room(settings.resolution()), _ -> new ArrayList<>())
                            .add(scan.mapFromBase().position()));
        }
        for (Ready robot : ready) {
            trodden.computeIfAbsent(robot.body().room(settings.resolution()), _ -> new ArrayList<>())
                    .add(robot.place());
        }
        for (var room : trodden.entrySet()) {
            map = VisitedCells.free(map, room.getValue(), room.getKey());
        }
        return map;
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
