package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
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
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Movers;
import rsal.navigation.avoid.ObstacleMemory;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.Yielding;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.traffic.TrafficRule;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Drives along planned ways: looks ten times a second at where the robot is and what is around it, and asks the
/// [NavigationTask] what to command. Without a goal, and while paused, it commands nothing, so others may drive.
/// A new goal does not end a pause. While motors are off it waits as if paused: that is nobody's failure.
final class PathNavigator extends DeviceCore implements Navigator {
    static final double BEAT_SECONDS = 0.1;
    private static final Duration BEAT = Duration.ofMillis(100);
    private static final Duration FRESH = Duration.ofMillis(700); // older readings are not driven by

    private static final double STRANGE = 0.3; // m from the next wall of the map
    private static final double RANGE_NOISE =
            0.06; // m per m; two deviations of a cheap laser, or walls would seem to move
    private static final double STRANGER_ROOM = 0.05; // m, standing
    private static final double STRANGER_ROOM_PER_SPEED = 0.4; // m per m/s; a stranger as fast needs it to stop, too
    private static final Duration STRANGERS_FADE = Duration.ofSeconds(15);

    private static final double MEETING = 3.5; // m; who comes from there on is met on the right
    private static final double PREDICTED_BEYOND = 0.35; // m from the robot's circle; nearer it could not move any more

    private static final double BEHIND = Math.toRadians(60); // to each side
    private static final int BEHIND_RAYS = 6; // to each side; a chair's leg fits between, a cabinet doesn't
    private static final double STRAIGHT_BACK = Math.toRadians(30); // to each side
    private static final double MOST_UNSURE = 0.1; // m

    /// What it is made of.
    ///
    /// @param plugins of which each goal has its own
    /// @param toNotFree how far the next wall of the map is
    /// @param traffic who goes first where others are
    record Parts(
            DriveBase base,
            Localizer localizer,
            Optional<LaserScanner> laser,
            Optional<SonarArray> sonars,
            Controller avoidance,
            GlobalPlanner planner,
            TaskPlugins plugins,
            DistanceField toNotFree,
            TrafficRule traffic) {}

    /// @param lookahead how far ahead on the way it aims [m]
    /// @param view how far around what it sees counts [m]
    /// @param bodyRadius of the circle that the robot turns in [m]
    /// @param patience how long it tries without getting nearer to the goal
    /// @param predictsMovers whether it foresees where those go that move
    record Settings(
            DriveLimits limits,
            double lookahead,
            double view,
            double bodyRadius,
            Duration replanPeriod,
            Duration patience,
            boolean predictsMovers) {}

    /// What a beat sees.
    ///
    /// @param seesBehind whether anything looks straight back
    /// @param meetsOthers whether somebody comes towards the robot
    record Situation(
            Instant now,
            PoseEstimate estimate,
            Motion motion,
            boolean stalled,
            Obstacles obstacles,
            boolean seesBehind,
            boolean meetsOthers) {
        Pose2d mapFromBase() {
            return estimate.mapFromBase();
        }
    }

    private Parts parts;
    private final Settings settings;
    private final Scheduler scheduler;
    private final Obstacles obstacles;
    private final ObstacleMemory blindSpot;
    private final Movers movers = new Movers();
    private final Movers.KnownPlaces known = this::isOnMap;
    private final Yielding yielding;
    private @Nullable NavigationTask task;
    private boolean paused;
    private boolean held; // as motors were off
    private boolean driving; // by its last command, not only turning

    PathNavigator(DeviceInfo info, Parts parts, Settings settings, Scheduler scheduler) {
        super(info);
        this.parts = parts;
        this.settings = settings;
        this.scheduler = scheduler;
        this.obstacles = new Obstacles(settings.view());
        this.blindSpot = new ObstacleMemory(3 * settings.bodyRadius(), STRANGERS_FADE);
        this.yielding = new Yielding(settings.limits(), settings.bodyRadius());
    }

    void start() {
        scheduler.every(BEAT, Phase.DEVICES, this::beat);
    }

    /// Gives it another map, from its next goal on. Other robots have other maps, so they do not agree on passages.
    void on(GlobalPlanner planner, DistanceField toNotFree) {
        parts = new Parts(
                parts.base(),
                parts.localizer(),
                parts.laser(),
                parts.sonars(),
                parts.avoidance(),
                planner,
                parts.plugins(),
                toNotFree,
                TrafficRule.NONE);
    }

    @Override
    public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
        if (!mapFromGoal.isFinite()) {
            throw new IllegalArgumentException("A goal must be finite, not '%s'.".formatted(mapFromGoal));
        }
        NavigationTask old = task;
        var next = new NavigationTask(parts, settings, scheduler, mapFromGoal, tolerance, this::onEnd);
        task = next;
        if (old == null) {
            parts.avoidance().reset();
        } else {
            next.succeed(old);
            old.end(Result.Cancelled.by(mapFromGoal));
        }
        return next.handle();
    }

    @Override
    public void pause() {
        if (!paused && task != null) {
            parts.base().command(Twist2d.STOP);
        }
        paused = true;
    }

    @Override
    public void resume() {
        if (paused && task != null) {
            task.resume();
        }
        paused = false;
    }

    @Override
    public boolean paused() {
        return paused;
    }

    @Override
    public Optional<Pose2d> goal() {
        return Optional.ofNullable(task).map(NavigationTask::mapFromGoal);
    }

    @Override
    public Optional<OccupancyGrid> costMap() {
        return Optional.of(parts.planner().map().shown());
    }

    @Override
    public Path2d path() {
        return task == null ? Path2d.EMPTY : task.path();
    }

    @Override
    public Path2d localPath() {
        return task == null || paused || !driving ? Path2d.EMPTY : task.localPath();
    }

    private void onEnd(NavigationTask ended) {
        if (ended.equals(task)) {
            task = null;
            parts.base().command(Twist2d.STOP);
        }
    }

    private void beat() {
        NavigationTask now = task;
        boolean off = !parts.base().enabled();
        if (now == null || paused || off) {
            held |= off;
            driving = false;
            fresh(parts.localizer())
                    .ifPresent(estimate -> parts.traffic()
                            .stands(scheduler.instant(), estimate.value().mapFromBase()));
            if (!health().isOk()) {
                look(); // it may be well again
            }
            return;
        }
        if (held) {
            now.resume();
            held = false;
        }
        Optional<Situation> situation = look();
        Twist2d command =
                situation.map(seen -> yielding(now.beat(seen), now, seen)).orElseGet(now::blindBeat);
        driving = command.vx() != 0;
        if (now.equals(task)) {
            parts.base().command(command);
        }
    }

    private Twist2d yielding(Twist2d wanted, NavigationTask now, Situation seen) {
        if (!settings.predictsMovers() || !now.equals(task)) {
            return wanted;
        }
        Twist2d command = yielding.yielding(wanted, movers, seen.obstacles(), seen.motion(), parts.avoidance());
        if (!command.equals(wanted)) {
            now.onYielding();
        }
        return command;
    }

    /// What is around; empty, with the reason as health, when something needed is missing or old.
    private Optional<Situation> look() {
        Optional<Stamped<PoseEstimate>> estimate = fresh(parts.localizer());
        Optional<Stamped<Odometry>> odometry = fresh(parts.base());
        Optional<Stamped<LaserScan>> scan = parts.laser()
                .flatMap(this::fresh)
                .filter(s -> ReadingValidator.fault(s.value()).isEmpty());
        if (estimate.isEmpty() || odometry.isEmpty()) {
            health(new Health.Stale(
                    estimate.isEmpty() ? "The localizer does not say where the robot is." : "No odometry."));
            return Optional.empty();
        }
        var ranges = parts.sonars()
                .flatMap(this::fresh)
                .filter(r -> ReadingValidator.fault(r.value()).isEmpty());
        boolean sighted = parts.laser().isPresent() ? scan.isPresent() : ranges.isPresent();
        if (!sighted) {
            health(new Health.Stale("No ranges: it does not drive blindly."));
            return Optional.empty();
        }
        health(Health.ok());
        Pose2d odomFromBase = odometry.get().value().odomFromBase();
        obstacles.clear();
        scan.ifPresent(s -> obstacles.add(s.value()));
        ranges.ifPresent(r ->
                scan.ifPresentOrElse(s -> obstacles.addBeside(s.value(), r.value()), () -> obstacles.add(r.value())));
        double room = STRANGER_ROOM
                + STRANGER_ROOM_PER_SPEED * odometry.get().value().velocity().speed();
        keepOffStrangers(estimate.get().value().mapFromBase(), room);
        scan.ifPresent(s -> {
            blindSpot.recall(s.value(), odomFromBase, scheduler.instant(), room, obstacles);
            blindSpot.note(s.value(), obstacles, odomFromBase, scheduler.instant());
            addWallsBehind(estimate.get().value());
            if (settings.predictsMovers()) {
                movers.see(
                        s.value(),
                        s.time(),
                        odomFromBase,
                        estimate.get().value().mapFromBase(),
                        known);
                movers.predict(obstacles, settings.bodyRadius() + PREDICTED_BEYOND, room);
            }
        });
        return Optional.of(new Situation(
                scheduler.instant(),
                estimate.get().value(),
                new Motion(odomFromBase, odometry.get().value().velocity()),
                odometry.get().value().stalled(),
                obstacles,
                seesBehind(scan, ranges),
                movers.isAnyComing(MEETING)));
    }

    private static boolean seesBehind(Optional<Stamped<LaserScan>> scan, Optional<Stamped<RangeArray>> ranges) {
        return scan.stream().anyMatch(s -> Obstacles.looks(s.value(), Math.PI))
                || ranges.stream()
                        .flatMap(r -> r.value().baseFromSensors().stream())
                        .anyMatch(mount -> Math.cos(mount.theta()) < -Math.cos(STRAIGHT_BACK));
    }

    /// The laser doesn't see behind the robot, but the map knows of walls there, as exactly as the robot knows where
    /// it is.
    private void addWallsBehind(PoseEstimate estimate) {
        Pose2d mapFromBase = estimate.mapFromBase();
        double reach = 2 * settings.bodyRadius();
        double unsure = Math.min(MOST_UNSURE, estimate.covariance().positionDeviation());
        for (int ray = -BEHIND_RAYS; ray <= BEHIND_RAYS; ray++) {
            double direction = Math.PI + ray * BEHIND / BEHIND_RAYS;
            double range =
                    parts.toNotFree().castRay(mapFromBase.x(), mapFromBase.y(), mapFromBase.theta() + direction, reach);
            if (range < reach) {
                double nearest = Math.max(0, range - unsure);
                obstacles.add(nearest * Math.cos(direction), nearest * Math.sin(direction));
            }
        }
    }

    private boolean isOnMap(double x, double y, double range) {
        return parts.toNotFree().at(x, y) <= STRANGE + RANGE_NOISE * range;
    }

    /// What is not on the map may move, and towards the robot.
    private void keepOffStrangers(Pose2d mapFromBase, double room) {
        for (int i = 0; i < obstacles.count(); i++) {
            Point2d place = mapFromBase.transform(obstacles.at(i));
            if (parts.toNotFree().at(place.x(), place.y()) > STRANGE) {
                obstacles.keepRoom(i, room);
            }
        }
    }

    private <T> Optional<Stamped<T>> fresh(Sensor<T> sensor) {
        Instant oldest = scheduler.instant().minus(FRESH);
        return sensor.latest().filter(reading -> !reading.time().isBefore(oldest));
    }
}
