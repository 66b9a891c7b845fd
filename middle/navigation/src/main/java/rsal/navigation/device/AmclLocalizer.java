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
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.SensorCore;
import rsal.device.SonarArray;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.Beams;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// A localizer by [Amcl]. Each odometry reading gives an estimate: the newest belief, moved as the wheels moved
/// since. The belief itself is corrected beside the other robots' work ([Scheduler#compute]) when the robot has
/// moved enough; ranges that come meanwhile are skipped.
///
/// Without ranges or odometry it falls silent and is stale until they are back. Bad readings are skipped
/// ([ReadingValidator]), the first with a word in the log, and counted in its health when no good ones come;
/// then those of a clock that was set back are taken, too. When the filter fails it is lost and silent, and
/// starts again from what it believed until that works.
final class AmclLocalizer extends SensorCore<PoseEstimate> implements Localizer {
    private static final Logger LOG = System.getLogger(AmclLocalizer.class.getName());
    private static final Duration PATIENCE = Duration.ofSeconds(2);

    private final Amcl amcl;
    private final OccupancyGrid map;
    private final Scheduler scheduler;
    private final List<CompletableFuture<Void>> followers = new ArrayList<>();
    private final ReadingValidator scrutiny = ReadingValidator.ofAnyScans(this::printSkipped);
    private final RecentOdometry wheels = new RecentOdometry();
    private Supplier<List<Mate>> mates = List::of;
    private Optional<PoseEstimate> start;
    private boolean restart = true;
    private boolean follows; // the belief follows the newest start
    private boolean busy;
    private boolean failed;
    private @Nullable Belief belief;
    private @Nullable Stamped<ParticleCloud> particles;
    private Instant lastRanges;
    private Instant lastOdometry;

    /// The result of an update.
    private record Corrected(PoseEstimate estimate, ParticleCloud particles) {}

    /// What is believed, and where odometry was then.
    private record Belief(PoseEstimate estimate, Pose2d odomFromBase) {
        PoseEstimate moved(Pose2d odomFromBaseNow) {
            return estimate.moved(odomFromBase.inverse().compose(odomFromBaseNow));
        }
    }

    /// @param map on which the filter works
    AmclLocalizer(DeviceInfo info, Amcl amcl, OccupancyGrid map, Optional<PoseEstimate> start, Scheduler scheduler) {
        super(info);
        this.amcl = amcl;
        this.map = map;
        this.scheduler = scheduler;
        this.start = start;
        this.lastRanges = scheduler.instant();
        this.lastOdometry = lastRanges;
    }

    void follow(DriveBase base) {
        base.subscribe(this::onOdometry);
        scheduler.every(PATIENCE, Phase.DEVICES, this::checkHealth);
    }

    void look(LaserScanner laser, int beams, double maxRange) {
        laser.subscribe(scan -> {
            if (scrutiny.accepts(scan)) {
                Supplier<LaserScan> walls = withoutMates(scan.value());
                onRanges(scan.time(), () -> Beams.of(walls.get(), beams, maxRange));
            }
        });
    }

    /// Robots of the team are no part of the building: beams that end at them say nothing about where this one is.
    /// Computed when it is asked for, with what is known now.
    private Supplier<LaserScan> withoutMates(LaserScan scan) {
        List<Mate> near = mates.get();
        Belief known = belief;
        Optional<Pose2d> odomFromBase = wheels.newest();
        if (near.isEmpty() || known == null || odomFromBase.isEmpty()) {
            return () -> scan;
        }
        Pose2d mapFromBase = known.moved(odomFromBase.get()).mapFromBase();
        return () -> Mate.leaveOut(near, scan, mapFromBase);
    }

    /// Hears of robots of the team.
    ///
    /// @param others where they are now
    void knows(Supplier<List<Mate>> others) {
        mates = others;
    }

    void look(SonarArray sonars, double maxRange) {
        sonars.subscribe(ranges -> {
            if (scrutiny.acceptsRanges(ranges)) {
                onRanges(ranges.time(), () -> Beams.of(ranges.value(), maxRange));
            }
        });
    }

    @Override
    public Optional<OccupancyGrid> givenMap() {
        return Optional.of(map);
    }

    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        if (!belief.isFinite()) {
            throw new IllegalArgumentException("A robot can't be at '%s'.".formatted(belief));
        }
        start = Optional.of(belief);
        restart = true;
        follows = false;
        var follower = new CompletableFuture<Void>();
        followers.add(follower);
        return follower.minimalCompletionStage();
    }

    @Override
    public Optional<Stamped<ParticleCloud>> particles() {
        return Optional.ofNullable(particles);
    }

    private void onOdometry(Stamped<Odometry> odometry) {
        if (!scrutiny.acceptsOdometry(odometry)) {
            return;
        }
        lastOdometry = scheduler.instant();
        wheels.add(odometry);
        if (belief == null && start.isPresent()) {
            belief = new Belief(start.get(), odometry.value().odomFromBase());
        }
        // Wheels alone are no localizer.
        if (belief != null && !failed && !isSilent(lastRanges)) {
            deliver(new Stamped<>(
                    odometry.time(), "map", belief.moved(odometry.value().odomFromBase())));
            answerFollowers();
        }
    }

    private void answerFollowers() {
        if (follows && !followers.isEmpty()) {
            var answered = List.copyOf(followers);
            followers.clear();
            answered.forEach(f -> f.complete(null));
        }
    }

    private void printSkipped(String reported) {
        LOG.log(Level.WARNING, () -> "'%s' skips bad readings.%s".formatted(info().id(), reported));
    }

    /// Waits until everything measured at this instant is here, odometry too.
    private void onRanges(Instant time, Supplier<Beams> beams) {
        lastRanges = scheduler.instant();
        if (!busy) {
            busy = true;
            scheduler.after(Duration.ZERO, Phase.DEVICES, () -> correct(time, beams));
        }
    }

    private void correct(Instant time, Supplier<Beams> beams) {
        Optional<Pose2d> odometry = wheels.odomFromBase(time);
        if (wheels.hasForgotten(time)) {
            scrutiny.skipTooOld();
        }
        if (odometry.isEmpty() || !(restart || amcl.due(odometry.get(), beams))) {
            busy = false;
            return;
        }
        Pose2d odomFromBase = odometry.get();
        boolean again = restart;
        Optional<PoseEstimate> from = start;
        restart = false;
        var work = scheduler.compute(() -> {
            if (again) {
                from.ifPresentOrElse(amcl::start, amcl::startAnywhere);
            }
            return new Corrected(amcl.update(odomFromBase, beams.get()), amcl.particles());
        });
        work.whenComplete((found, error) -> {
            busy = false;
            if (error != null) {
                fail(error, odomFromBase);
                return;
            }
            failed = false;
            if (!restart) { // else someone knows better by now
                belief = new Belief(found.estimate(), odomFromBase);
                particles = new Stamped<>(time, "map", found.particles());
                follows = true;
            }
        });
    }

    /// What the failure left of the particles is not to be trusted.
    private void fail(Throwable error, Pose2d odomFromBase) {
        if (!failed) {
            LOG.log(Level.ERROR, () -> "The particle filter of '%s' failed.".formatted(info().id()), error);
        }
        failed = true;
        health(new Health.Lost("The particle filter failed: %s".formatted(error)));
        if (!restart && belief != null) { // else someone knows better by now
            start = Optional.of(belief.moved(odomFromBase));
        }
        restart = true;
    }

    private void checkHealth() {
        if (failed) {
            return; // that is worse
        }
        if (isSilent(lastRanges)) {
            health(silence("ranges"));
        } else if (isSilent(lastOdometry)) {
            health(silence("odometry"));
        }
    }

    private Health silence(String what) {
        Health stale = scrutiny.silence(what, PATIENCE);
        scrutiny.reset();
        return stale;
    }

    private boolean isSilent(Instant last) {
        return last.plus(PATIENCE).isBefore(scheduler.instant());
    }
}
