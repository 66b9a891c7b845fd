package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Sensor;
import rsal.device.SonarArray;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.vfh.DriveLimits;
import rsal.navigation.vfh.Obstacles;
import rsal.navigation.vfh.Vfh;
import rsal.navigation.wavefront.CostMap;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Drives along planned ways: looks ten times a second at where the robot is and what is around it, and asks the
/// [Trip] under way what to command. Without a goal, and while paused, it commands nothing, so others may drive.
final class PathNavigator extends DeviceCore implements Navigator {
    static final double BEAT_SECONDS = 0.1;
    private static final Duration BEAT = Duration.ofMillis(100);
    private static final Duration FRESH = Duration.ofMillis(700); // older readings are not driven by

    /// What it is made of.
    ///
    /// @param toNotFree how far the next wall of the map is
    record Parts(
            DriveBase base,
            Localizer localizer,
            Optional<LaserScanner> laser,
            Optional<SonarArray> sonars,
            Vfh vfh,
            CostMap costs,
            DistanceField toNotFree) {}

    /// @param lookahead how far ahead on the way it aims [m]
    /// @param bodyRadius of the circle that the robot turns in [m]
    /// @param escapeSpeed for backing off [m/s]
    /// @param escapeTime for backing off, at most
    /// @param patience how long it tries without getting nearer to the goal
    record Settings(
            DriveLimits limits,
            double lookahead,
            double bodyRadius,
            Duration replanPeriod,
            double escapeSpeed,
            Duration escapeTime,
            Duration patience) {}

    /// What a beat sees.
    record Situation(
            Instant now,
            PoseEstimate estimate,
            Pose2d odomFromBase,
            Twist2d velocity,
            boolean stalled,
            Obstacles obstacles) {
        Pose2d mapFromBase() {
            return estimate.mapFromBase();
        }
    }

    private final Parts parts;
    private final Settings settings;
    private final Scheduler scheduler;
    private final RandomGenerator random;
    private final Obstacles obstacles;
    private @Nullable Trip trip;
    private boolean paused;

    PathNavigator(DeviceInfo info, Parts parts, Settings settings, Scheduler scheduler, RandomGenerator random) {
        super(info);
        this.parts = parts;
        this.settings = settings;
        this.scheduler = scheduler;
        this.random = random;
        this.obstacles = new Obstacles(settings.lookahead() + 2 * settings.bodyRadius());
    }

    void start() {
        scheduler.every(BEAT, Phase.DEVICES, this::beat);
    }

    @Override
    public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
        if (!mapFromGoal.isFinite()) {
            throw new IllegalArgumentException("A goal must be finite, not (%s).".formatted(mapFromGoal));
        }
        Trip old = trip;
        var next = new Trip(parts, settings, scheduler, random, mapFromGoal, tolerance, this::onEnd);
        trip = next;
        paused = false;
        if (old == null) {
            parts.vfh().reset();
        } else {
            next.succeed(old);
            old.end(new Result.Cancelled());
        }
        return next.handle();
    }

    @Override
    public void pause() {
        if (!paused && trip != null) {
            parts.base().command(Twist2d.STOP);
        }
        paused = true;
    }

    @Override
    public void resume() {
        if (paused && trip != null) {
            trip.resume();
        }
        paused = false;
    }

    @Override
    public boolean paused() {
        return paused;
    }

    @Override
    public Optional<Pose2d> goal() {
        return Optional.ofNullable(trip).map(Trip::mapFromGoal);
    }

    @Override
    public Path2d path() {
        return trip == null ? Path2d.EMPTY : trip.path();
    }

    private void onEnd(Trip ended) {
        if (ended.equals(trip)) {
            trip = null;
            parts.base().command(Twist2d.STOP);
        }
    }

    private void beat() {
        Trip now = trip;
        if (now == null || paused) {
            return;
        }
        Optional<Situation> situation = look();
        Twist2d command = situation.map(now::beat).orElseGet(now::blindBeat);
        if (now.equals(trip)) {
            parts.base().command(command);
        }
    }

    /// What is around; empty, with the reason as health, when something needed is missing or old.
    private Optional<Situation> look() {
        Optional<Stamped<PoseEstimate>> estimate = fresh(parts.localizer());
        Optional<Stamped<Odometry>> odometry = fresh(parts.base());
        Optional<Stamped<LaserScan>> scan = parts.laser().flatMap(this::fresh);
        if (estimate.isEmpty() || odometry.isEmpty()) {
            health(new Health.Stale(
                    estimate.isEmpty() ? "The localizer does not say where the robot is." : "No odometry."));
            return Optional.empty();
        }
        var ranges = parts.sonars().flatMap(this::fresh);
        boolean sighted = parts.laser().isPresent() ? scan.isPresent() : ranges.isPresent();
        if (!sighted) {
            health(new Health.Stale("No ranges: it does not drive blindly."));
            return Optional.empty();
        }
        health(Health.ok());
        obstacles.clear();
        scan.ifPresent(s -> obstacles.add(s.value()));
        ranges.ifPresent(r ->
                scan.ifPresentOrElse(s -> obstacles.addBeside(s.value(), r.value()), () -> obstacles.add(r.value())));
        return Optional.of(new Situation(
                scheduler.instant(),
                estimate.get().value(),
                odometry.get().value().odomFromBase(),
                odometry.get().value().velocity(),
                odometry.get().value().stalled(),
                obstacles));
    }

    private <T> Optional<Stamped<T>> fresh(Sensor<T> sensor) {
        Instant oldest = scheduler.instant().minus(FRESH);
        return sensor.latest().filter(reading -> !reading.time().isBefore(oldest));
    }
}
