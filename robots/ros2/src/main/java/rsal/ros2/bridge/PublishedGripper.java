package rsal.ros2.bridge;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import rsal.data.GripperState;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.Gripper.Result;
import rsal.ros2.action.ActionServer;
import rsal.ros2.action.ActionServer.ServedGoal;
import rsal.ros2.action.ActionServer.Status;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink;
import rsal.ros2.simulation.PublishedTime;

/// Paddles or a lift of a gripper of ours as an action of type `control_msgs/GripperCommand`. It knows two places, so a
/// position stands for the nearer one: 0 is closed or down, the greatest one is open or up [m]. A new goal takes the
/// place of the one before, which is aborted.
final class PublishedGripper implements ActionServer.Handler {
    private final Gripper gripper;
    private final Motion motion;
    private final ActionServer server;
    private final Map<ServedGoal, GoalHandle<GripperState, Result>> moves = new HashMap<>();

    /// What an action moves.
    ///
    /// @param greatest position [m]
    /// @param toZero moves it to 0
    /// @param toGreatest moves it to the greatest position
    /// @param position where it is [m]
    /// @param canHold whether a thing can stop it on its way to 0
    record Motion(
            double greatest,
            Function<Gripper, GoalHandle<GripperState, Result>> toZero,
            Function<Gripper, GoalHandle<GripperState, Result>> toGreatest,
            ToDoubleFunction<GripperState> position,
            boolean canHold) {}

    /// @param services which this closes
    /// @param name with its namespace: `/r1/gripper_controller/gripper_cmd`
    PublishedGripper(
            Gripper gripper, Motion motion, RosLink link, Services services, String name, PublishedTime scheduler) {
        this.gripper = gripper;
        this.motion = motion;
        server = new ActionServer(link, services, name, "control_msgs/action/GripperCommand", scheduler, this);
    }

    @Override
    public void begin(ServedGoal goal, RosMessage fields) {
        double wanted = fields.message("command").number("position");
        if (!Double.isFinite(wanted)) {
            goal.end(Status.ABORTED, this::writeNoResult);
            return;
        }
        boolean isZero = wanted < motion.greatest / 2;
        GoalHandle<GripperState, Result> move = (isZero ? motion.toZero : motion.toGreatest).apply(gripper);
        moves.put(goal, move);
        move.onFeedback(reported -> goal.publishFeedback(state(reported.value(), false, false)));
        move.result().thenAccept(ending -> {
            moves.remove(goal);
            end(goal, ending, isZero);
        });
    }

    private void end(ServedGoal goal, Result ending, boolean isZero) {
        switch (ending) {
            case Result.Reached(GripperState state) -> {
                boolean isHeld = isZero && motion.canHold && state.holding();
                goal.end(Status.SUCCEEDED, state(state, isHeld, !isHeld));
            }
            case Result.Cancelled _ ->
                goal.end(goal.isCanceling() ? Status.CANCELED : Status.ABORTED, this::writeNoResult);
            case Result.Stuck(GripperState state, String _) -> {
                boolean isStalled = !isZero; // paddles that are stuck while they close would count as holding something
                goal.end(Status.ABORTED, state(state, isStalled, false));
            }
        }
    }

    /// `GripperCommand_Feedback` or `GripperCommand_Result`; efforts are not known.
    private Consumer<CdrWriter> state(GripperState state, boolean isStalled, boolean isReached) {
        double position = motion.position.applyAsDouble(state);
        return writer -> writer.float64(position).float64(0).bool(isStalled).bool(isReached);
    }

    @Override
    public void cancel(ServedGoal goal) {
        Optional.ofNullable(moves.get(goal)).ifPresent(GoalHandle::cancel);
    }

    @Override
    public void writeNoResult(CdrWriter writer) {
        double position = gripper.latest()
                .map(reading -> motion.position.applyAsDouble(reading.value()))
                .orElse(0.0);
        writer.float64(position).float64(0).bool(false).bool(false);
    }

    /// Ends all goals.
    void abortAll() {
        server.abortAll();
    }

    void close() {
        server.close();
    }
}
