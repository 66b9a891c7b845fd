package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.ActuatorState;
import rsal.data.ActuatorState.Joint;
import rsal.data.ActuatorState.Motion;
import rsal.data.Interval;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Actuator;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Health;
import rsal.robot.RobotModel.Part;
import rsal.robot.Shift;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// A simulated joint, at its speed at once. (In Stage 4.3 joints don't move.) What stands on it moves with it.
/// Only pieces of the robot's body can run into something: then it stops and is stuck. It is one of the robot's
/// motors, and off when these are.
final class SimActuator extends SimActuatedDevice<ActuatorState> implements Actuator {
    private final Part.Actuator part;
    private final SimDrive drive;
    private final InstantSource clock;
    private final Duration watchdog;
    private double position;
    private double target;
    private double wanted; // speed
    private double speed;
    private Instant commanded = Instant.MIN;
    private boolean arrived; // and not told yet
    private @Nullable Stop stop; // what stopped it in the last step
    private @Nullable ArticulatedMotion bending; // of the body; null when it carries nothing of that
    private DeviceMount standsOn = DeviceMount.BASE;
    private @Nullable GoalSource<ActuatorState, Result> goal;
    private @Nullable GoalSource<ActuatorState, Result> inProgress; // in the last step

    /// @param by empty for a wall
    record Stop(Optional<Body> by) {}

    SimActuator(DeviceInfo info, Part.Actuator part, SimDrive drive, InstantSource clock, Duration watchdog) {
        super(info, info.id(), part.period());
        this.part = part;
        this.drive = drive;
        this.clock = clock;
        this.watchdog = watchdog;
        this.position = part.home();
    }

    @Override
    public GoalHandle<ActuatorState, Result> goTo(double wantedPosition) {
        requireFinite(wantedPosition);
        stop(new Result.Cancelled());
        target = part.limits().clamp(wantedPosition);
        GoalSource<ActuatorState, Result> next = new GoalSource<>(() -> stop(new Result.Cancelled()));
        goal = next;
        return next;
    }

    @Override
    public GoalHandle<ActuatorState, Result> home() {
        return goTo(part.home());
    }

    @Override
    public void command(double newSpeed) {
        requireFinite(newSpeed);
        stop(new Result.Cancelled());
        if (drive.enabled()) {
            wanted = Interval.around0(part.maxSpeed()).clamp(newSpeed);
            commanded = clock.instant();
        }
    }

    /// Lets it carry pieces of the robot's body.
    ///
    /// @param mount what it stands on itself
    void bend(ArticulatedMotion body, DeviceMount mount) {
        bending = body;
        standsOn = mount;
    }

    /// How far it has carried what stands on it.
    Shift shift() {
        return part.shift(position);
    }

    /// What stopped it in the last step.
    Optional<Stop> stopped() {
        return Optional.ofNullable(stop);
    }

    private void requireFinite(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    "A command of '%s' must be finite, not '%s'.".formatted(info().id(), value));
        }
    }

    private void stop(Result ending) {
        GoalSource<ActuatorState, Result> ended = goal;
        goal = null;
        arrived = false;
        wanted = 0;
        if (ended != null) {
            ended.end(ending);
        }
    }

    @Override
    void work(Instant now, double dt) {
        double before = position;
        double most = drive.enabled() ? part.maxSpeed() * dt : 0;
        inProgress = goal;
        if (goal != null) {
            moveTo(Math.clamp(target, before - most, before + most));
            arrived = position == target;
        } else {
            wanted = drive.enabled() && now.isBefore(commanded.plus(watchdog)) ? wanted : 0;
            moveTo(part.limits().clamp(before + wanted * dt));
        }
        speed = (position - before) / dt;
        if (isDue(now)) {
            take(state(), now);
        } else if (arrived || (goal != null && stop != null)) {
            takeNow(state(), now);
        }
    }

    private void moveTo(double next) {
        double before = position;
        stop = null;
        if (bending == null || next == before) {
            position = next;
            return;
        }
        double made = bending.move(longestDistance(bending, next), part -> position = between(before, next, part));
        position = between(before, next, made);
        stop = made < 1 ? new Stop(bending.obstacle()) : null;
    }

    private static double between(double from, double to, double part) {
        return part == 1 ? to : from + part * (to - from);
    }

    /// That a point on it makes, at most [m].
    private double longestDistance(ArticulatedMotion body, double next) {
        double distance = Math.abs(next - position);
        if (part.joint() == Joint.LINEAR) {
            return distance;
        }
        Pose2d joint = standsOn.now().moved(part.baseFromJoint());
        return distance * (body.radius() + Math.hypot(joint.x(), joint.y()));
    }

    private ActuatorState state() {
        Motion standing = wanted == 0 && stop == null ? Motion.IDLE : Motion.STALLED;
        return new ActuatorState(part.joint(), position, speed, part.limits(), speed == 0 ? standing : Motion.MOVING);
    }

    @Override
    void reported(Stamped<ActuatorState> reading) {
        GoalSource<ActuatorState, Result> now = goal;
        if (now != null && now == inProgress) { // a listener may have begun another
            now.publish(reading);
            if (arrived && now == goal) {
                stop(new Result.Reached(position));
            } else if (stop != null && now == goal) {
                String obstacle = stop.by.map(Body::name).orElse(World.WALL);
                stop(new Result.Stuck(position, "'%s' is in its way.".formatted(obstacle)));
            }
        }
    }

    @Override
    void close(Health.Lost why) {
        super.close(why);
        stop(new Result.Stuck(position, why.reason()));
    }
}
