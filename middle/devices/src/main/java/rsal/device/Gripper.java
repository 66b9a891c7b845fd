package rsal.device;

import rsal.data.GripperState;

/// Two paddles that close around things, and possibly a lift. Frame of its readings: `<robot>/<name>`.
///
/// The paddles and the lift each have one goal at a time: a new goal for the paddles ends their present goal as
/// cancelled, and the same applies to the lift. Paddles and lift are independent of each other. After a
/// cancelled goal, they stay at their positions. While the [motors of its robot][DriveBase#enable] are off, the
/// gripper stands still, and its goals wait.
public interface Gripper extends Sensor<GripperState> {
    /// Opens the paddles and releases what they hold.
    GoalHandle<GripperState, Result> open();

    /// Closes the paddles until they hold something or meet. Both are [Result.Reached]; [GripperState#holding]
    /// tells which.
    GoalHandle<GripperState, Result> close();

    /// Moves the lift up. Without a lift it is stuck at once.
    GoalHandle<GripperState, Result> lift();

    /// Moves the lift down. Without a lift it is there already.
    GoalHandle<GripperState, Result> lower();

    /// Closes, then lifts.
    default GoalHandle<GripperState, Result> closeAndLift() {
        return close().then(Result.Reached.class::isInstance, this::lift);
    }

    /// Lowers, then opens.
    default GoalHandle<GripperState, Result> lowerAndOpen() {
        return lower().then(Result.Reached.class::isInstance, this::open);
    }

    sealed interface Result {
        /// Paddles or lift are where they were to be.
        record Reached(GripperState state) implements Result {}

        /// The goal was cancelled, or another one took its place.
        record Cancelled() implements Result {}

        /// It can't go on, or the device is lost.
        record Stuck(GripperState state, String why) implements Result {}
    }
}
