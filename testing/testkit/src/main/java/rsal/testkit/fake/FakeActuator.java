package rsal.testkit.fake;

import java.time.InstantSource;
import org.jspecify.annotations.Nullable;
import rsal.data.ActuatorState;
import rsal.data.ActuatorState.Motion;
import rsal.data.Interval;
import rsal.data.Stamped;
import rsal.device.Actuator;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.robot.RobotModel.Part;

/// A joint without inertia, which is off when its robot's motors are.
public final class FakeActuator extends FakeSensor<ActuatorState> implements Actuator {
    private static final int WATCHDOG_STEPS = 5;

    private final Part.Actuator part;
    private final FakeDriveBase base;
    private final InstantSource clock;
    private double position;
    private double target;
    private double wanted; // speed
    private int stepsSinceCommand = WATCHDOG_STEPS;
    private @Nullable GoalSource<ActuatorState, Result> goal;

    FakeActuator(DeviceInfo info, Part.Actuator part, FakeDriveBase base, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.clock = clock;
        this.position = part.home();
        this.target = position;
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
    public void command(double speed) {
        requireFinite(speed);
        stop(new Result.Cancelled());
        if (base.enabled()) {
            wanted = Interval.around0(part.maxSpeed()).clamp(speed);
            stepsSinceCommand = 0;
        }
    }

    private static void requireFinite(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("An actuator is told something finite, not '%s'.".formatted(value));
        }
    }

    private void stop(Result ending) {
        GoalSource<ActuatorState, Result> ended = goal;
        goal = null;
        target = position;
        wanted = 0;
        if (ended != null) {
            ended.end(ending);
        }
    }

    @Override
    void sense() {
        double before = position;
        double most = base.enabled() ? part.maxSpeed() * FakeSystem.STEP_SECONDS : 0;
        if (goal != null) {
            position = Math.clamp(target, position - most, position + most);
        } else if (base.enabled() && stepsSinceCommand++ < WATCHDOG_STEPS) {
            position = part.limits().clamp(position + wanted * FakeSystem.STEP_SECONDS);
        }
        double speed = (position - before) / FakeSystem.STEP_SECONDS;
        var state = new ActuatorState(
                part.joint(), position, speed, part.limits(), speed == 0 ? Motion.IDLE : Motion.MOVING);
        var reading = new Stamped<>(clock.instant(), info().id(), state);
        deliver(reading);
        if (goal != null) {
            goal.publish(reading);
        }
        if (goal != null && position == target) {
            stop(new Result.Reached(position));
        }
    }

    @Override
    void shutDown() {
        stop(new Result.Stuck(position, "The system was closed."));
    }
}
