package rsal.navigation.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Quality;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.SensorCore;
import rsal.navigation.grid.ScanMapper.PosedScan;
import rsal.navigation.slam.GraphResidual;
import rsal.navigation.slam.Slam;
import rsal.navigation.slam.Tracking;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// A localizer that needs no map, as it makes its own ([Slam]). Each odometry reading gives an estimate: where
/// the newest scan was taken that was looked at, moved as the wheels moved since. Scans are looked at beside
/// the other robots' work ([Scheduler#compute]); those that come meanwhile are skipped, and so are those that
/// tell nothing new: of places less than 5 cm and 2° from where one matched less than half a second ago. When a
/// loop closes, estimates jump. How sure an estimate is, is told against what was mapped around it
/// ([Tracking]): it errs more the farther the wheels led it since a scan matched, and is lost when they don't
/// match for long. When a loop has bent the map by more than anything that was told of the way errs
/// ([GraphResidual#tooLarge]), one of the two is probably wrong: then estimates are ambiguous at best, less sure
/// the more it is bent, and a word in the log says where.
///
/// Its map's frame is that of the pose it was told to start from, else one of its own, `<robot>/map`, in which
/// it starts at the origin. Told otherwise where it is, it begins a new map from there. Without scans or
/// odometry it is stale and silent; when mapping fails it is lost and begins a new map from where it is. Bad
/// readings are skipped ([ReadingValidator]), the first with a word in the log, and counted in its health when
/// no good ones come.
final class SlamLocalizer extends SensorCore<PoseEstimate> implements Localizer {
    private static final Logger LOG = System.getLogger(SlamLocalizer.class.getName());
    private static final Duration PATIENCE = Duration.ofSeconds(2);
    private static final double SAME_METERS = 0.05; // a cell of the map
    private static final double SAME_RADIANS = Math.toRadians(2);
    private static final Duration SAME_TIME = Duration.ofMillis(500); // somebody may push a robot that stands

    private final Slam.Settings settings;
    private final Scheduler scheduler;
    private final List<CompletableFuture<Void>> followers = new ArrayList<>();
    private final ReadingValidator scrutiny = ReadingValidator.ofScansAlike(this::printSkipped);
    private Supplier<List<Mate>> mates = List::of;
    private Pose2d start;
    private boolean reported; // where it was
    private @Nullable Slam slam; // only the work under way touches it
    private @Nullable Known known; // of the newest scan
    private Pose2d slamFromOdom = Pose2d.ORIGIN; // by which odometry is handed to it
    private List<PosedScan> map = List.of();
    private Optional<GraphResidual.Step> bent = Optional.empty(); // too much
    private final RecentOdometry odometry = new RecentOdometry();
    private boolean busy;
    private boolean failed;
    private Instant lastScan;
    private Instant lastOdometry;

    private record Found(
            Slam slam,
            Pose2d mapFromBase,
            Tracking tracking,
            @Nullable List<PosedScan> map,
            @Nullable GraphResidual residual) {}

    /// Where the robot was when a scan was taken, and how sure that is.
    private record Known(Instant taken, Pose2d mapFromBase, Pose2d odomFromBase, Tracking tracking) {
        /// Whether a scan would show what the one before did, which matched.
        boolean isOf(Instant time, Pose2d odomFromBaseThen) {
            return tracking.seeing()
                    && time.isBefore(taken.plus(SAME_TIME))
                    && odomFromBase.isNear(odomFromBaseThen, SAME_METERS, SAME_RADIANS);
        }

        /// Moved as the wheels moved since.
        PoseEstimate at(Pose2d odomFromBaseNow) {
            Pose2d motion = odomFromBase.inverse().compose(odomFromBaseNow);
            return tracking.moved(motion).at(mapFromBase.compose(motion));
        }
    }

    SlamLocalizer(DeviceInfo info, Slam.Settings settings, Optional<Pose2d> mapFromBase, Scheduler scheduler) {
        super(info);
        this.settings = settings;
        this.scheduler = scheduler;
        this.start = mapFromBase.orElse(Pose2d.ORIGIN);
        this.reported = mapFromBase.isPresent();
        this.lastScan = scheduler.instant();
        this.lastOdometry = lastScan;
    }

    void follow(DriveBase base, LaserScanner laser) {
        base.subscribe(this::onOdometry);
        laser.subscribe(this::onScan);
        scheduler.every(PATIENCE, Phase.DEVICES, this::checkHealth);
    }

    /// Keeps robots off the map that tell where they are on it.
    ///
    /// @param others where they are now
    void knows(Supplier<List<Mate>> others) {
        mates = others;
    }

    /// The newest belief, seen from where the wheels led since.
    private PoseEstimate estimate(Known belief, Pose2d odomFromBase) {
        PoseEstimate estimate = belief.at(odomFromBase);
        return bent.map(step -> doubted(estimate, step)).orElse(estimate);
    }

    /// Sure as far as the map can be.
    private static PoseEstimate doubted(PoseEstimate estimate, GraphResidual.Step bent) {
        return new PoseEstimate(
                estimate.mapFromBase(),
                estimate.covariance(),
                estimate.hypotheses(),
                estimate.confidence() * GraphResidual.TOO_MUCH / bent.deviations(),
                estimate.quality() == Quality.LOCALIZED ? Quality.AMBIGUOUS : estimate.quality());
    }

    /// Of its map: that of the world when somebody told it where it was, else one of its own.
    String frame() {
        return reported ? "map" : info().robot() + "/map";
    }

    /// The scans that were kept, where they were taken, as of the newest of them.
    List<PosedScan> map() {
        return map;
    }

    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        if (!belief.mapFromBase().isFinite()) {
            throw new IllegalArgumentException("A robot can't be at '%s'.".formatted(belief.mapFromBase()));
        }
        reported = true;
        begin(belief.mapFromBase());
        var follower = new CompletableFuture<Void>();
        followers.add(follower);
        return follower.minimalCompletionStage();
    }

    private void begin(Pose2d mapFromBase) {
        start = mapFromBase;
        slam = null;
        known = null;
        map = List.of();
        bent = Optional.empty();
        scrutiny.reset();
    }

    private void onOdometry(Stamped<Odometry> reading) {
        if (!scrutiny.acceptsOdometry(reading)) {
            return;
        }
        lastOdometry = scheduler.instant();
        odometry.add(reading);
        if (known != null && !failed && !isSilent(lastScan)) {
            deliver(new Stamped<>(
                    reading.time(), frame(), estimate(known, reading.value().odomFromBase())));
            var answered = List.copyOf(followers);
            followers.clear();
            answered.forEach(f -> f.complete(null));
        }
    }

    /// Waits until everything measured at this instant is here, odometry too.
    private void onScan(Stamped<LaserScan> scan) {
        if (!scrutiny.accepts(scan)) {
            return;
        }
        lastScan = scheduler.instant();
        if (!busy) {
            busy = true;
            scheduler.after(Duration.ZERO, Phase.DEVICES, () -> look(scan));
        }
    }

    private void printSkipped(String reported) {
        LOG.log(Level.WARNING, () -> "'%s' skips bad readings.%s".formatted(info().id(), reported));
    }

    private void look(Stamped<LaserScan> scan) {
        Optional<Pose2d> taken = odometry.odomFromBase(scan.time());
        if (odometry.hasForgotten(scan.time())) {
            scrutiny.skipTooOld();
        }
        if (taken.isEmpty() || (known != null && known.isOf(scan.time(), taken.get()))) {
            busy = false;
            return;
        }
        Pose2d odomFromBase = taken.get();
        Slam before = slam;
        if (before == null) {
            slamFromOdom = start.compose(odomFromBase.inverse());
        }
        Slam mapper = before == null ? new Slam(settings) : before;
        slam = mapper;
        Pose2d reported = slamFromOdom.compose(odomFromBase);
        Pose2d mapFromBase = known == null ? start : known.at(odomFromBase).mapFromBase();
        LaserScan seen = Mate.leaveOut(mates.get(), scan.value(), mapFromBase);
        scheduler.compute(work(mapper, reported, seen)).whenComplete((found, error) -> {
            busy = false;
            if (error != null) {
                fail(error);
            } else if (found.slam().equals(slam)) { // else someone knows better by now
                failed = false;
                known = new Known(scan.time(), found.mapFromBase(), odomFromBase, found.tracking());
                if (found.map() != null) {
                    map = found.map();
                }
                if (found.residual() != null) {
                    learn(found.residual());
                }
            }
        });
    }

    private static Supplier<Found> work(Slam slam, Pose2d odomFromBase, LaserScan scan) {
        return () -> {
            int frames = slam.frameCount();
            int fits = slam.fits();
            Pose2d mapFromBase = slam.pose(slam.add(odomFromBase, scan));
            return new Found(
                    slam,
                    mapFromBase,
                    slam.tracking(),
                    slam.frameCount() > frames ? slam.posedScans() : null,
                    slam.fits() > fits ? slam.graphResidual() : null); // what is just added is not bent
        };
    }

    private void learn(GraphResidual residual) {
        boolean news = bent.isEmpty();
        bent = residual.tooLarge();
        bent.filter(_ -> news).ifPresent(step -> {
            Pose2d place = map.get(step.to()).mapFromBase();
            LOG.log(
                    Level.WARNING,
                    () -> ("The map of '%s' is probably wrong: at (%.1f, %.1f) it differs from all measurements of the"
                                    + " robot's path by at least %.2f m and %.0f°. Maybe places that look alike were taken"
                                    + " for one, or the robot was carried.")
                            .formatted(
                                    info().id(), place.x(), place.y(), step.meters(), Math.toDegrees(step.radians())));
        });
    }

    private void fail(Throwable error) {
        if (!failed) {
            LOG.log(Level.ERROR, () -> "Mapping of '%s' failed.".formatted(info().id()), error);
        }
        failed = true;
        health(new Health.Lost("Mapping failed: %s".formatted(error)));
        Optional<Pose2d> now = odometry.newest();
        if (known != null && now.isPresent()) {
            begin(known.at(now.get()).mapFromBase());
        } else {
            slam = null;
        }
    }

    private void checkHealth() {
        if (failed) {
            return; // that is worse
        }
        if (isSilent(lastScan)) {
            health(scrutiny.silence("scan", PATIENCE));
        } else if (isSilent(lastOdometry)) {
            health(scrutiny.silence("odometry", PATIENCE));
        }
    }

    private boolean isSilent(Instant last) {
        return last.plus(PATIENCE).isBefore(scheduler.instant());
    }
}
