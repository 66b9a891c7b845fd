package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Gripper;
import rsal.device.Health;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.RosMessages;

/// A gripper behind one action for its paddles, and another one for its lift if it has one. Where they are comes by
/// `joint_states`; of robots that do not publish these joints, by the feedback and the results of goals. It holds
/// something when the robot says so (`holding`), or when something stopped its paddles.
final class RosGripper extends RosSensor<GripperState> implements Gripper {
    private static final Duration PERIOD = Duration.ofMillis(100); // of readings without joint states
    private static final Duration PATIENCE = Duration.ofSeconds(1); // without anybody who serves the action
    private static final double NEAR = 0.03; // of the way: as near as positions are told

    private final String action;
    private final GripperJoint paddles;
    private final Optional<GripperJoint> lift;
    private final RosContext context;
    private final Map<GripperFlag, Boolean> flags = new EnumMap<>(GripperFlag.class); // those that were told
    private boolean hasJoints;
    private boolean isServed = true; // as far as is known
    private Instant reportedAlone = Instant.MIN; // without joint states
    private Instant served = Instant.MIN; // when somebody served the action last

    /// @param action of the paddles, for people
    RosGripper(DeviceInfo info, String action, GripperJoint paddles, Optional<GripperJoint> lift, RosContext context) {
        super(info, info.id(), action);
        this.action = action;
        this.paddles = paddles;
        this.lift = lift;
        this.context = context;
        paddles.onEnd(this::publishNow);
        lift.ifPresent(its -> its.onEnd(this::publishNow));
        context.base().onMotors(this::motors);
    }

    private void motors(boolean enabled) {
        if (enabled) {
            paddles.resume();
            lift.ifPresent(GripperJoint::resume);
        } else {
            paddles.hold();
            lift.ifPresent(GripperJoint::hold);
        }
    }

    /// @param message `sensor_msgs/JointState` with its joints, or others only
    void take(RosMessage message) {
        List<?> names = message.get("name", List.class);
        double[] positions = message.get("position", double[].class);
        int own = names.indexOf(context.settings().gripper().joint());
        int lifts = names.indexOf(context.settings().gripper().liftJoint());
        if (lifts >= 0 && lifts < positions.length) {
            lift.ifPresent(its -> its.moved(positions[lifts]));
        }
        if (own >= 0 && own < positions.length) {
            hasJoints = true;
            paddles.moved(positions[own]);
            heard(context.frames().now());
            publishAt(context.clock().time(RosMessages.stamp(message.message("header"))));
        }
    }

    void take(GripperFlag flag, RosMessage message) {
        flags.put(flag, message.get("data", Boolean.class));
    }

    /// One that nobody moves is lost, wherever its joints are.
    private void publishAt(Instant time) {
        if (!isServed) {
            return;
        }
        publish(time, state());
        latest().ifPresent(reading -> {
            paddles.publish(reading);
            lift.ifPresent(its -> its.publish(reading));
        });
    }

    /// At the end of a goal: what is known by it. Listeners hear it, unless nobody serves the gripper: it stays lost.
    private Stamped<GripperState> publishNow() {
        Stamped<GripperState> reading = reading(context.frames().now(), state());
        if (isServed) {
            deliver(reading);
        }
        return reading;
    }

    private GripperState state() {
        boolean isHolding = flag(GripperFlag.HOLDING).orElse(paddles.isStalled());
        return new GripperState(
                paddles(isHolding),
                paddles.part(),
                lift.map(RosGripper::lift).orElse(Lift.DOWN),
                lift.map(GripperJoint::part).orElse(0.0),
                flag(GripperFlag.INNER_BEAM).orElse(isHolding),
                flag(GripperFlag.OUTER_BEAM).orElse(false),
                flag(GripperFlag.LEFT_CONTACT).orElse(isHolding),
                flag(GripperFlag.RIGHT_CONTACT).orElse(isHolding),
                isHolding);
    }

    private Optional<Boolean> flag(GripperFlag flag) {
        return Optional.ofNullable(flags.get(flag));
    }

    private Paddles paddles(boolean isHolding) {
        double closed = paddles.part();
        return switch (paddles.direction()) {
            case 1 -> Paddles.CLOSING;
            case -1 -> Paddles.OPENING;
            default -> closed < NEAR ? Paddles.OPEN : closed > 1 - NEAR || isHolding ? Paddles.CLOSED : Paddles.STOPPED;
        };
    }

    private static Lift lift(GripperJoint joint) {
        double raised = joint.part();
        return switch (joint.direction()) {
            case 1 -> Lift.RISING;
            case -1 -> Lift.SINKING;
            default -> raised < NEAR ? Lift.DOWN : raised > 1 - NEAR ? Lift.UP : Lift.STOPPED;
        };
    }

    @Override
    public GoalHandle<GripperState, Result> open() {
        return paddles.begin(0);
    }

    @Override
    public GoalHandle<GripperState, Result> close() {
        return paddles.begin(1);
    }

    @Override
    public GoalHandle<GripperState, Result> lift() {
        return lift.map(its -> its.begin(1)).orElseGet(() -> ended(new Result.Stuck(state(), "It has no lift.")));
    }

    @Override
    public GoalHandle<GripperState, Result> lower() {
        return lift.map(its -> its.begin(0)).orElseGet(() -> ended(new Result.Reached(state())));
    }

    private static GoalHandle<GripperState, Result> ended(Result ending) {
        var goal = new GoalSource<GripperState, Result>(() -> {});
        goal.end(ending);
        return goal;
    }

    /// Looks whether somebody serves its action; without joint states, tells what is known.
    void look(Instant now) {
        paddles.look(now);
        lift.ifPresent(its -> its.look(now));
        if (paddles.isAvailable()) {
            served = now;
            isServed = true;
        } else if (served.equals(Instant.MIN) || served.plus(PATIENCE).isBefore(now)) {
            String why = "Nobody serves '%s'.".formatted(action);
            paddles.fail(why);
            lift.ifPresent(its -> its.fail(why));
            isServed = false;
            health(new Health.Lost(why));
            return;
        }
        if (hasJoints) {
            look(now, 1);
        } else if (!reportedAlone.plus(PERIOD).isAfter(now)) {
            reportedAlone = now;
            publishAt(now);
        }
    }

    /// For good.
    void end() {
        paddles.close();
        lift.ifPresent(GripperJoint::close);
    }
}
