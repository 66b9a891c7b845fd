package rsal.testkit.fake;

import java.time.Duration;
import java.time.InstantSource;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Gripper;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel.Part;

/// A gripper that holds whatever grippable thing has its middle between the paddles. It is off when its robot's
/// motors are.
public final class FakeGripper extends FakeSensor<GripperState> implements Gripper {
    private final Part.Gripper part;
    private final FakeDriveBase base;
    private final FakeWorld world;
    private final InstantSource clock;
    private final Axis paddles;
    private final Axis lift;
    private @Nullable Held held;

    FakeGripper(DeviceInfo info, Part.Gripper part, FakeDriveBase base, FakeWorld world, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.world = world;
        this.clock = clock;
        this.paddles = new Axis(part.closingTime());
        this.lift = new Axis(part.liftingTime());
    }

    @Override
    public GoalHandle<GripperState, Result> open() {
        held = null;
        return paddles.goTo(0);
    }

    @Override
    public GoalHandle<GripperState, Result> close() {
        return paddles.goTo(held == null ? 1 : paddles.motor.position());
    }

    @Override
    public GoalHandle<GripperState, Result> lift() {
        GoalHandle<GripperState, Result> goal = lift.goTo(part.hasLift() ? 1 : 0);
        if (!part.hasLift()) {
            lift.end(new Result.Stuck(state(), "It has no lift."));
        }
        return goal;
    }

    @Override
    public GoalHandle<GripperState, Result> lower() {
        return lift.goTo(0);
    }

    @Override
    void sense() {
        boolean closing = paddles.motor.direction() > 0;
        if (base.enabled()) {
            paddles.motor.step();
            lift.motor.step();
        }
        if (held == null && closing) {
            between()
                    .filter(thing -> thing.grippable() && gap() <= 2 * FakeWorld.radius(thing))
                    .ifPresent(this::hold);
        }
        if (held != null) {
            world.move(held.thing, base.mapFromBase().compose(held.baseFromThing));
        }
        var reading = new Stamped<>(clock.instant(), info().id(), state());
        deliver(reading);
        paddles.publish(reading);
        lift.publish(reading);
    }

    private void hold(Thing thing) {
        held = new Held(thing.name(), base.mapFromBase().inverse().compose(thing.mapFromThing()));
        paddles.motor.stop();
    }

    @Override
    void shutDown() {
        paddles.end(new Result.Stuck(state(), "The system was closed."));
        lift.end(new Result.Stuck(state(), "The system was closed."));
    }

    private <M> Optional<M> moving(Axis axis, M up, M down) {
        return base.enabled() ? axis.moving(up, down) : Optional.empty();
    }

    private GripperState state() {
        double closed = paddles.motor.position();
        double raised = lift.motor.position();
        boolean contact =
                between().filter(t -> gap() <= 2 * FakeWorld.radius(t)).isPresent();
        return new GripperState(
                moving(paddles, Paddles.CLOSING, Paddles.OPENING)
                        .orElse(
                                closed == 0
                                        ? Paddles.OPEN
                                        : closed == 1 || held != null ? Paddles.CLOSED : Paddles.STOPPED),
                closed,
                moving(lift, Lift.RISING, Lift.SINKING)
                        .orElse(raised == 0 ? Lift.DOWN : raised == 1 ? Lift.UP : Lift.STOPPED),
                raised,
                isBroken(0.75),
                isBroken(0.25),
                contact,
                contact,
                held != null);
    }

    /// Between the paddles now [m].
    private double gap() {
        return part.opening() * (1 - paddles.motor.position());
    }

    private Optional<Thing> between() {
        return world.things().stream()
                .filter(thing -> {
                    Pose2d at = gripperFromThing(thing);
                    return at.x() <= part.length() / 2
                            && at.x() >= part.length() / 2 - part.paddleLength()
                            && Math.abs(at.y()) <= part.opening() / 2;
                })
                .findFirst();
    }

    /// @param depth of the beam behind the tips, as a share of the paddles' length
    private boolean isBroken(double depth) {
        double beam = part.length() / 2 - depth * part.paddleLength();
        return world.things().stream()
                .anyMatch(thing -> Math.abs(gripperFromThing(thing).x() - beam) <= FakeWorld.radius(thing)
                        && Math.abs(gripperFromThing(thing).y()) <= part.opening() / 2);
    }

    private Pose2d gripperFromThing(Thing thing) {
        Pose2d mapFromGripper = base.mapFromBase().compose(part.baseFromGripper());
        return mapFromGripper.inverse().compose(thing.mapFromThing());
    }

    private record Held(String thing, Pose2d baseFromThing) {}

    /// Paddles or lift, and what they are to do.
    private static final class Axis {
        private final FakeMotor motor;
        private @Nullable GoalSource<GripperState, Result> goal;

        Axis(Duration time) {
            motor = new FakeMotor(0, time.isZero() ? 0 : 1e9 / time.toNanos());
        }

        GoalHandle<GripperState, Result> goTo(double position) {
            end(new Result.Cancelled());
            motor.goTo(position);
            GoalSource<GripperState, Result> next = new GoalSource<>(() -> end(new Result.Cancelled()));
            goal = next;
            return next;
        }

        void end(Result ending) {
            GoalSource<GripperState, Result> ended = goal;
            goal = null;
            motor.stop();
            if (ended != null) {
                ended.end(ending);
            }
        }

        void publish(Stamped<GripperState> reading) {
            if (goal != null) {
                goal.publish(reading);
            }
            if (goal != null && motor.arrived()) {
                end(new Result.Reached(reading.value()));
            }
        }

        <M> Optional<M> moving(M up, M down) {
            return motor.arrived() ? Optional.empty() : Optional.of(motor.direction() > 0 ? up : down);
        }
    }
}
