package rsal.navigation.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.device.SensorCore;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.Wavefront;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Sends a robot where its map ends, until it ends nowhere that the robot can get to. Its readings are the
/// map. It gives its navigator the map, too, and takes the robot over from the start unless it is told to wait: who
/// wants to drive it by its navigator pauses the explorer, who wants to drive it otherwise pauses the navigator.
final class Explorer extends SensorCore<OccupancyGrid> implements Mapper {
    private static final Duration LONGEST = Duration.ofSeconds(60); // for one frontier without getting there
    private static final Duration FRESH = Duration.ofSeconds(5);
    private static final int SURE = 2; // looks; a map that was just bent may hide an end for one
    private static final double NEARER = 0.3; // m that count as getting nearer
    private static final Navigator.Tolerance THERE = new Navigator.Tolerance(0.3, 0.5); // m, rad

    private static final Logger LOG = System.getLogger(Explorer.class.getName());

    private final Localizer localizer;
    private final SlamLocalizer slam;
    private final PathNavigator navigator;
    private final Exploration team;
    private final Exploration.Body body;
    private final Scheduler scheduler;
    private @Nullable GoalHandle<Navigator.Progress, Navigator.Result> drive;
    private @Nullable Point2d frontier;
    private double nearest;
    private Instant since = Instant.MIN;
    private int looksForNothing; // in a row, in which there was nothing more to get to
    private boolean paused;
    private List<End> ends = List.of();
    private Wavefront wavefront = nowhere();

    /// @param localizer that tells where it is, `slam` or what stands in its place
    Explorer(
            DeviceInfo info,
            Localizer localizer,
            SlamLocalizer slam,
            PathNavigator navigator,
            Exploration team,
            Exploration.Body body,
            boolean waits,
            Scheduler scheduler) {
        super(info);
        this.localizer = localizer;
        this.slam = slam;
        this.navigator = navigator;
        this.team = team;
        this.body = body;
        this.paused = waits;
        this.scheduler = scheduler;
    }

    /// Paths while nothing is mapped.
    private static Wavefront nowhere() {
        OccupancyGrid unknown = new OccupancyGrid(1, 1, 1, 0, 0, new byte[] {OccupancyGrid.UNKNOWN});
        return new Wavefront(CostMap.of(unknown, DistanceField.toNotFree(unknown), new CostMap.Clearance(0, 0, 0)));
    }

    void start() {
        slam.knows(() -> team.mates(this));
        navigator.on(
                wavefront,
                DistanceField.toNotFree(wavefront.map().grid())); // the run's map is not for robots that explore
        team.join(this);
        Instant begin = scheduler.instant().plus(FRESH);
        scheduler.every(Exploration.PERIOD, Phase.DEVICES, () -> {
            if (health().isOk() && begin.isBefore(scheduler.instant()) && !ready()) {
                health(new Health.Stale("It does not know where the robot is, and sends it nowhere."));
            }
            team.look(scheduler);
        });
    }

    /// Whether it knows where it is; one that has left the run doesn't.
    boolean ready() {
        Instant oldest = scheduler.instant().minus(FRESH);
        return localizer
                        .latest()
                        .filter(estimate -> !estimate.time().isBefore(oldest))
                        .isPresent()
                && !slam.map().isEmpty();
    }

    Exploration.Body body() {
        return body;
    }

    List<PosedScan> seen() {
        return slam.map();
    }

    Point2d place() {
        return localizer.latest().orElseThrow().value().mapFromBase().position();
    }

    @Override
    public boolean isComplete() {
        return looksForNothing >= SURE;
    }

    @Override
    public void pause() {
        paused = true;
        frontier = null;
        var under = drive;
        drive = null;
        if (under != null) {
            under.cancel();
        }
    }

    @Override
    public void resume() {
        paused = false;
    }

    @Override
    public boolean paused() {
        return paused;
    }

    @Override
    public List<End> ends() {
        return ends;
    }

    @Override
    public void leaveAlone(End end) {
        team.leaveAlone(end.mapFromMiddle(), scheduler.instant());
    }

    /// Where it is on its way to.
    Optional<Point2d> frontier() {
        return Optional.ofNullable(frontier);
    }

    /// How its robot gets about on the map as told last.
    Wavefront wavefront() {
        return wavefront;
    }

    void take(Exploration.Order order) {
        if (!health().isOk()) { // it stood meanwhile, for no fault of the frontier's
            nearest = Double.POSITIVE_INFINITY;
            since = scheduler.instant();
        }
        health(Health.ok());
        looksForNothing = order.complete() ? looksForNothing + 1 : 0;
        if (looksForNothing == SURE && !order.narrow().isEmpty()) {
            reportNarrow(order);
        }
        deliver(new Stamped<>(scheduler.instant(), slam.frame(), order.map()));
        wavefront = order.wavefront();
        ends = order.ends();
        navigator.on(wavefront, order.toNotFree());
        if (paused) {
            return;
        }
        Exploration.Goal goal = order.goal().orElse(null);
        if (goal == null) {
            frontier = null;
            if (drive != null) {
                drive.cancel();
            }
            return;
        }
        if (frontier == null || frontier.distanceTo(goal.frontier()) > NEARER) {
            since = scheduler.instant();
            nearest = Double.POSITIVE_INFINITY;
        }
        frontier = goal.frontier();
        double left = place().distanceTo(goal.stand());
        if (left < nearest - NEARER) {
            nearest = left;
            since = scheduler.instant();
        } else if (since.plus(LONGEST).isBefore(scheduler.instant())) {
            team.leaveAlone(goal.frontier(), scheduler.instant());
            frontier = null;
            return;
        }
        var next = navigator.goTo(goal.mapFromStand(), THERE);
        drive = next;
        next.result().thenAccept(result -> ended(next, goal.frontier(), result));
    }

    private void reportNarrow(Exploration.Order order) {
        Point2d first = order.narrow().getFirst();
        LOG.log(
                Level.WARNING,
                () -> ("'%s' can't get to %d frontiers of its map, as at (%.1f, %.1f), since passages there are "
                                + "too narrow by less than three cells. Maybe set a smaller `resolution` than (%s m) or a "
                                + "smaller `wallDistance` of its explorer.")
                        .formatted(
                                info().robot(),
                                order.narrow().size(),
                                first.x(),
                                first.y(),
                                order.map().resolution()));
    }

    private void ended(GoalHandle<Navigator.Progress, Navigator.Result> ended, Point2d goal, Navigator.Result result) {
        if (ended.equals(drive) && !(result instanceof Navigator.Result.Cancelled)) {
            drive = null;
            frontier = null;
            if (ready()) {
                team.leaveAlone(goal, scheduler.instant());
            }
        }
    }

    void fail(Throwable error) {
        health(new Health.Lost("Exploring failed: %s".formatted(error)));
    }
}
