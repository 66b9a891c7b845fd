package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.GripperState;
import rsal.data.Stamped;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Gripper.Result;
import rsal.ros2.action.ActionClient;
import rsal.ros2.cdr.RosMessage;

/// Paddles or a lift behind an action of type `control_msgs/GripperCommand`, between two positions: 0 (open,
/// down) and 1 (closed, up). While its robot's motors are off, its goals wait, and one under way is canceled
/// and sent again.
final class GripperJoint {
    private static final Duration PATIENCE = Duration.ofSeconds(15);

    private final ActionClient action;
    private final RosContext context;
    private final double zero;
    private final double one;
    private final double effort;
    private Supplier<Stamped<GripperState>> reported = () -> {
        throw new IllegalStateException("Nothing publishes the state of the gripper.");
    };
    private double position = Double.NaN;
    private int target;
    private boolean stalled; // by what is between the paddles
    private Instant begun = Instant.MIN;
    private @Nullable GoalSource<GripperState, Result> goal;
    private ActionClient.@Nullable Goal sent;

    /// @param zero position of the joint [m or rad]
    /// @param one position of the joint [m or rad]
    /// @param effort greatest [N or Nm]; 0 for the controller's own
    GripperJoint(ActionClient action, RosContext context, double zero, double one, double effort) {
        this.action = action;
        this.context = context;
        this.zero = zero;
        this.one = one;
        this.effort = effort;
    }

    /// @param reading tells how the gripper is now, and gives the reading
    void onEnd(Supplier<Stamped<GripperState>> reading) {
        reported = reading;
    }

    /// Begins a goal; the one before it is cancelled.
    GoalHandle<GripperState, Result> begin(int place) {
        cancel();
        target = place;
        var next = new GoalSource<GripperState, Result>(this::cancel);
        goal = next;
        if (action.isAvailable()) {
            resume();
        } else {
            end(state -> new Result.Stuck(state, "No server offers its action."));
        }
        return next;
    }

    private void cancel() {
        hold();
        GoalSource<GripperState, Result> ended = goal;
        goal = null;
        if (ended != null) {
            ended.end(new Result.Cancelled());
        }
    }

    /// As soon as it may.
    void resume() {
        if (goal != null && sent == null && context.base().enabled()) {
            begun = context.scheduler().instant();
            stalled = stalled && target == 1;
            double wanted = target == 1 ? one : zero;
            var pursuit = new Pursuit(goal);
            sent = action.send(command -> command.float64(wanted).float64(effort), pursuit);
        }
    }

    /// It stays where it is.
    void hold() {
        if (sent != null) {
            action.cancel(sent);
            sent = null;
        }
    }

    /// What comes of one message to the robot.
    private final class Pursuit implements ActionClient.Listener {
        private final GoalSource<GripperState, Result> its;

        Pursuit(GoalSource<GripperState, Result> its) {
            this.its = its;
        }

        @Override
        public void onFeedback(RosMessage message) {
            moved(message.number("position"));
        }

        @Override
        public void onRefused() {
            finish(state -> new Result.Stuck(state, "The robot's gripper refused the goal."));
        }

        /// Paddles that something stops have closed: controllers call that a success or not, as they are set.
        @Override
        public void onResult(RosMessage response) {
            RosMessage result = response.message("result");
            int status = (int) response.integer("status");
            boolean isStalled = result.get("stalled", Boolean.class);
            if (status == ActionClient.SUCCEEDED || (status == ActionClient.ABORTED && isStalled && target == 1)) {
                moved(result.number("position"));
                stalled = isStalled && target == 1;
                finish(Result.Reached::new);
            } else if (status == ActionClient.CANCELED) {
                if (its.equals(goal)) {
                    sent = null;
                    cancel();
                }
            } else {
                finish(state -> new Result.Stuck(state, "The robot's gripper gave up (status %d).".formatted(status)));
            }
        }

        @Override
        public void onFailure(String why) {
            hold();
            finish(state -> new Result.Stuck(state, why));
        }

        private void finish(Function<GripperState, Result> ending) {
            if (its.equals(goal)) {
                sent = null;
                end(ending);
            }
        }
    }

    /// The state is told once more, as at the end of the goal.
    private void end(Function<GripperState, Result> ending) {
        GoalSource<GripperState, Result> ended = goal;
        goal = null;
        if (ended != null) {
            Stamped<GripperState> last = reported.get();
            ended.publish(last);
            ended.end(ending.apply(last.value()));
        }
    }

    /// @param place of the joint [m or rad]
    void moved(double place) {
        if (Double.isFinite(place)) {
            position = place;
        }
    }

    /// How far it is from 0 to 1; NaN as long as nobody has told.
    double part() {
        return zero == one ? 0 : Math.clamp((position - zero) / (one - zero), 0, 1);
    }

    /// 1 while it moves towards 1, -1 towards 0, 0 while it stands.
    int direction() {
        return goal == null || !context.base().enabled() ? 0 : target == 1 ? 1 : -1;
    }

    boolean isStalled() {
        return stalled;
    }

    boolean isAvailable() {
        return action.isAvailable();
    }

    /// Tells how a goal gets on.
    void publish(Stamped<GripperState> reading) {
        if (goal != null) {
            goal.publish(reading);
        }
    }

    void look(Instant now) {
        action.look(now);
        if (sent != null && begun.plus(PATIENCE).isBefore(now)) {
            fail("It does not get there.");
        }
    }

    void fail(String why) {
        hold();
        end(state -> new Result.Stuck(state, why));
    }

    void close() {
        fail("The connection to the robot is closed.");
        action.close();
    }
}
