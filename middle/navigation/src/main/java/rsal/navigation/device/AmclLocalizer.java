package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
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
final class AmclLocalizer extends SensorCore<PoseEstimate> implements Localizer {
    private static final Duration PATIENCE = Duration.ofSeconds(2);

    private final Amcl amcl;
    private final Scheduler scheduler;
    private final List<CompletableFuture<Void>> followers = new ArrayList<>();
    private Optional<PoseEstimate> start;
    private boolean restart = true;
    private boolean follows; // the belief follows the newest start
    private boolean busy;
    private @Nullable Belief belief;
    private @Nullable Stamped<Odometry> older;
    private @Nullable Stamped<Odometry> newest;
    private @Nullable Stamped<ParticleCloud> particles;
    private Instant heard;

    /// What is believed, and where odometry was then.
    private record Belief(PoseEstimate estimate, Pose2d odomFromBase) {
        PoseEstimate moved(Pose2d odomFromBaseNow) {
            Pose2d way = odomFromBase.inverse().compose(odomFromBaseNow);
            return new PoseEstimate(
                    estimate.mapFromBase().compose(way),
                    estimate.covariance(),
                    estimate.hypotheses().stream()
                            .map(h -> new Hypothesis(h.weight(), h.mapFromBase().compose(way), h.covariance()))
                            .toList());
        }
    }

    AmclLocalizer(DeviceInfo info, Amcl amcl, Optional<PoseEstimate> start, Scheduler scheduler) {
        super(info);
        this.amcl = amcl;
        this.scheduler = scheduler;
        this.start = start;
        this.heard = scheduler.instant();
    }

    void follow(DriveBase base) {
        base.subscribe(this::onOdometry);
        scheduler.every(PATIENCE, Phase.DEVICES, this::checkHealth);
    }

    void look(LaserScanner laser, int beams, double maxRange) {
        laser.subscribe(scan -> onRanges(scan.time(), () -> Beams.of(scan.value(), beams, maxRange)));
    }

    void look(SonarArray sonars, double maxRange) {
        sonars.subscribe(ranges -> onRanges(ranges.time(), () -> Beams.of(ranges.value(), maxRange)));
    }

    @Override
    public CompletionStage<Void> relocalize(PoseEstimate belief) {
        if (!belief.mapFromBase().isFinite()) {
            throw new IllegalArgumentException("A robot can't be at (%s).".formatted(belief.mapFromBase()));
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
        older = newest;
        newest = odometry;
        if (belief == null && start.isPresent()) {
            belief = new Belief(start.get(), odometry.value().odomFromBase());
        }
        // Wheels alone are no localizer: without ranges it falls silent.
        if (belief != null && silence().compareTo(PATIENCE) <= 0) {
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

    /// Waits until everything measured at this instant is here, odometry too.
    private void onRanges(Instant time, Supplier<Beams> beams) {
        heard = scheduler.instant();
        if (!busy) {
            busy = true;
            scheduler.after(Duration.ZERO, Phase.DEVICES, () -> correct(time, beams));
        }
    }

    private void correct(Instant time, Supplier<Beams> beams) {
        Optional<Pose2d> odometry = odomFromBase(time);
        if (odometry.isEmpty() || !(restart || amcl.due(odometry.get()))) {
            busy = false;
            return;
        }
        if (restart) {
            start.ifPresentOrElse(amcl::start, amcl::startAnywhere);
            restart = false;
        }
        Pose2d odomFromBase = odometry.get();
        scheduler.compute(() -> amcl.update(odomFromBase, beams.get())).whenComplete((found, error) -> {
            busy = false;
            if (error != null) {
                health(new Health.Lost("The particle filter failed: %s".formatted(error)));
            } else if (!restart) { // else someone knows better by now
                belief = new Belief(found.estimate(), odomFromBase);
                particles = new Stamped<>(time, "map", found.particles());
                follows = true;
            }
        });
    }

    /// Odometry when the ranges were measured: between the two newest readings, or the newest when it is older.
    private Optional<Pose2d> odomFromBase(Instant time) {
        if (newest == null) {
            return Optional.empty();
        }
        Pose2d to = newest.value().odomFromBase();
        if (older == null || !time.isBefore(newest.time())) {
            return Optional.of(to);
        }
        Pose2d from = older.value().odomFromBase();
        double span = seconds(older.time(), newest.time());
        double share = span > 0 ? Math.clamp(seconds(older.time(), time) / span, 0, 1) : 1;
        return Optional.of(new Pose2d(
                from.x() + share * (to.x() - from.x()),
                from.y() + share * (to.y() - from.y()),
                from.theta() + share * Angles.difference(from.theta(), to.theta())));
    }

    private void checkHealth() {
        if (silence().compareTo(PATIENCE) > 0) {
            health(new Health.Stale("No ranges for more than %d s.".formatted(PATIENCE.toSeconds())));
        }
    }

    private Duration silence() {
        return Duration.between(heard, scheduler.instant());
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toNanos() / 1e9;
    }
}
