package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Health;
import rsal.device.Navigator;
import rsal.player.message.PlannerInterface;
import rsal.player.message.Pose;
import rsal.player.wire.Address;

/// A robot's own navigator, behind `planner`. A goal is reached when the robot is as near as was asked for, or when the
/// server has it so. The protocol has no way to call a goal off: the planner is switched off then, until there is a new
/// one. Nor does every base mind that its motors are off (Stage's does not): so the planner is switched off with them.
final class PlayerNavigator extends DeviceCore implements Navigator, Remote {
    private static final Duration NO_PATH = Duration.ofSeconds(5); // without one a goal has none
    private static final Duration STUCK = Duration.ofSeconds(60); // without getting nearer
    private static final Duration ASK = Duration.ofSeconds(1); // for waypoints
    private static final double NEARER = 0.2; // m
    private static final double OTHER_WAY = 1; // m, which no robot drives back between two states
    private static final double CLOSE = 1; // m; a planner that is done farther away speaks of the goal before

    private final Address address;
    private final RemoteServer server;
    private final PlayerBase base;
    private final InstantSource clock;
    private @Nullable DriveTask task;
    private boolean paused;
    private boolean calledOff; // the goal that the planner has
    private boolean on; // as the planner was told over this connection

    /// A goal with how it gets on.
    private static final class DriveTask {
        private final Pose2d mapFromGoal;
        private final Tolerance tolerance;
        private final Instant begun;
        private final GoalSource<Progress, Result> goal;
        private boolean sent; // to the planner
        private boolean underway; // as the planner has it
        private Optional<PlannerInterface.State> reported = Optional.empty();
        private List<Point2d> waypoints = List.of();
        private Instant asked = Instant.MIN; // for them
        private Instant valid; // when there was a way last
        private Instant nearer; // when it got nearer last
        private double remaining = Double.POSITIVE_INFINITY; // way, as known last [m]
        private double nearest = Double.POSITIVE_INFINITY; // shortest of those since it is that way [m]

        DriveTask(Pose2d mapFromGoal, Tolerance tolerance, Instant begun, GoalSource<Progress, Result> goal) {
            this.mapFromGoal = mapFromGoal;
            this.tolerance = tolerance;
            this.begun = begun;
            this.goal = goal;
            this.valid = begun;
            this.nearer = begun;
        }

        Pose2d mapFromBase() {
            return reported.map(state -> state.mapFromBase().to2d()).orElse(Pose2d.ORIGIN);
        }

        Path2d path() {
            if (reported.isEmpty()) {
                return Path2d.EMPTY;
            }
            var points = new ArrayList<Point2d>();
            points.add(mapFromBase().position());
            PlannerInterface.State state = reported.get();
            if (state.valid() != 0 && state.done() == 0 && state.waypoints() > 0) {
                points.add(state.waypoint().to2d().position());
            }
            int next = Math.clamp(state.waypointIndex(), 0, waypoints.size()); // some count on once they drive to it
            waypoints.subList(next, waypoints.size()).stream()
                    .filter(waypoint -> !waypoint.equals(points.getLast()))
                    .forEach(points::add);
            if (points.size() == 1) {
                points.add(mapFromGoal.position());
            }
            return new Path2d(points);
        }
    }

    /// @param base that it drives
    PlayerNavigator(DeviceInfo info, Address address, RemoteServer server, PlayerBase base, InstantSource clock) {
        super(info);
        this.address = address;
        this.server = server;
        this.base = base;
        this.clock = clock;
        base.onMotors(this::motors);
    }

    private void motors(boolean enabled) {
        if (enabled) {
            drive();
        } else {
            enable(false);
            if (task != null) {
                task.sent = false; // some servers forget the goal of a base that is told to stand
            }
        }
    }

    @Override
    public Address address() {
        return address;
    }

    @Override
    public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
        if (!mapFromGoal.isFinite()) {
            throw new IllegalArgumentException("A goal must be finite, not '%s'.".formatted(mapFromGoal));
        }
        end(Result.Cancelled.by(mapFromGoal));
        var goal = new DriveTask[1];
        GoalSource<Progress, Result> source = new GoalSource<>(() -> cancel(goal[0]));
        goal[0] = new DriveTask(mapFromGoal, tolerance, clock.instant(), source);
        if (!server.isConnected()) {
            source.end(new Result.Stuck(Pose2d.ORIGIN, Duration.ZERO, server.reason()));
            return source;
        }
        task = goal[0];
        drive();
        return source;
    }

    /// Has the planner drive to the goal that there is, unless somebody holds it back.
    private void drive() {
        DriveTask now = task;
        if (now == null || paused || !base.enabled()) {
            return;
        }
        if (!now.sent) {
            now.sent = true;
            calledOff = false;
            server.command(address, PlannerInterface.GOAL, new PlannerInterface.Place(Pose.of(now.mapFromGoal)));
        }
        enable(true);
    }

    private void cancel(DriveTask old) {
        if (old.equals(task)) {
            stop();
            end(Result.Cancelled.asked());
        }
    }

    private void stop() {
        calledOff = true;
        enable(false);
    }

    private void enable(boolean wanted) {
        if (!wanted || !on) { // off is said again and again, as others may switch it on
            on = wanted;
            server.ask(address, PlannerInterface.ENABLE, Optional.of(new PlannerInterface.Enable(wanted ? 1 : 0)))
                    .whenComplete((_, error) -> on &= error == null);
        }
    }

    /// Stops what it drives, for good.
    @Override
    public void end() {
        if (task != null) {
            stop();
            end(new Result.Cancelled("The connection to the robot is closed."));
        }
    }

    private void end(Result ending) {
        DriveTask ended = task;
        task = null;
        if (ended != null) {
            ended.goal.end(ending);
        }
    }

    @Override
    public void take(Instant time, Record body) {
        DriveTask now = task;
        if (now == null || !(body instanceof PlannerInterface.State state) || !isFinite(state)) {
            return;
        }
        boolean ours = state.mapFromGoal().to2d().isNear(now.mapFromGoal, 0.01, 0.01);
        now.reported = Optional.of(state);
        Pose2d mapFromBase = now.mapFromBase();
        boolean held = paused || !base.enabled();
        if (held || (ours && state.valid() != 0)) {
            now.valid = time;
        }
        double remaining = now.path().length();
        if (remaining > now.remaining + OTHER_WAY) {
            now.nearest = remaining;
        }
        now.remaining = remaining;
        if (held || remaining < now.nearest - NEARER) {
            now.nearest = Math.min(remaining, now.nearest);
            now.nearer = time;
        }
        Duration driving = Duration.between(now.begun, time);
        now.underway |= now.sent && ours && state.done() == 0;
        boolean close = mapFromBase.distanceTo(now.mapFromGoal) < CLOSE;
        boolean done = now.sent && ours && state.done() != 0 && (now.underway || close);
        if (done || mapFromBase.isNear(now.mapFromGoal, now.tolerance.distance(), now.tolerance.angle())) {
            if (!done) {
                stop();
            }
            end(new Result.Reached(mapFromBase));
        } else if (Duration.between(now.valid, time).compareTo(NO_PATH) > 0) {
            stop();
            end(new Result.NoPath("The robot's own planner has no path to the goal."));
        } else if (Duration.between(now.nearer, time).compareTo(STUCK) > 0) {
            stop();
            end(new Result.Stuck(mapFromBase, driving, "It got no nearer for %d s.".formatted(STUCK.toSeconds())));
        } else {
            Point2d waypoint = state.waypoints() > 0 ? state.waypoint().to2d().position() : now.mapFromGoal.position();
            now.goal.publish(new Stamped<>(time, "map", new Progress(mapFromBase, remaining, waypoint, driving)));
        }
    }

    private static boolean isFinite(PlannerInterface.State state) {
        return state.mapFromBase().to2d().isFinite()
                && state.mapFromGoal().to2d().isFinite()
                && state.waypoint().to2d().isFinite();
    }

    @Override
    public void look(Instant now) {
        DriveTask asking = task;
        if (asking != null && asking.asked.isBefore(now.minus(ASK))) {
            asking.asked = now;
            server.ask(address, PlannerInterface.WAYPOINTS, Optional.empty())
                    .thenAccept(answer -> answer.filter(PlannerInterface.Waypoints.class::isInstance)
                            .map(PlannerInterface.Waypoints.class::cast)
                            .ifPresent(reported -> asking.waypoints = points(reported.waypoints())));
        }
    }

    private static List<Point2d> points(List<Pose> waypoints) {
        return waypoints.stream()
                .map(waypoint -> waypoint.to2d().position())
                .filter(point -> Double.isFinite(point.x()) && Double.isFinite(point.y()))
                .toList();
    }

    @Override
    public void pause() {
        paused = true;
        enable(false);
    }

    @Override
    public void resume() {
        paused = false;
        drive();
    }

    @Override
    public boolean paused() {
        return paused;
    }

    @Override
    public Optional<Pose2d> goal() {
        return Optional.ofNullable(task).map(now -> now.mapFromGoal);
    }

    @Override
    public Path2d path() {
        return Optional.ofNullable(task).map(DriveTask::path).orElse(Path2d.EMPTY);
    }

    @Override
    public void connected() {
        health(Health.ok());
        base.motors(); // planners switch them on when they begin
        if (calledOff || paused || !base.enabled()) {
            enable(false);
        }
    }

    @Override
    public void lost(String reason) {
        DriveTask ended = task;
        if (ended != null) {
            stop(); // when it is back, too
            end(new Result.Stuck(ended.mapFromBase(), Duration.between(ended.begun, clock.instant()), reason));
        }
        on = false;
        health(new Health.Lost(reason));
    }
}
