package rsal.device;

import rsal.data.ActuatorState;

/// A joint that is moved by a motor: a lift, a turntable, a joint of an arm. It executes one command at a time:
/// a new command ends the present goal as cancelled. While the [motors of its robot][DriveBase#enable] are off,
/// it stands still and ignores speeds, and its goal waits. Frame of its readings: `<robot>/<name>`.
public interface Actuator extends Sensor<ActuatorState> {
    /// Moves to a position [m or rad] and holds it. Positions beyond the limits are cut to them.
    ///
    /// @throws IllegalArgumentException when the position is not finite
    GoalHandle<ActuatorState, Result> goTo(double position);

    /// Moves to its home position.
    GoalHandle<ActuatorState, Result> home();

    /// Moves at a speed [m/s or rad/s] until the next command or its limits, at most for 0.5 s (by default).
    /// Speeds beyond what it can do are cut.
    ///
    /// @throws IllegalArgumentException when the speed is not finite
    void command(double speed);

    sealed interface Result {
        /// It is where it was to be.
        ///
        /// @param position [m or rad]
        record Reached(double position) implements Result {}

        /// The goal was cancelled, or another one took its place.
        record Cancelled() implements Result {}

        /// It can't go on, or the device is lost.
        record Stuck(double position, String why) implements Result {}
    }
}
