package rsal.data;

/// State of a gripper (Player `gripper`, the lift as one joint of `actarray`, the light beams as `dio`).
///
/// @param paddles whether they are open, closed or moving
/// @param closed how far the paddles are closed: 0 open, 1 closed; NaN when the gripper cannot measure it
/// @param lift whether it is up, down or moving
/// @param raised how far the lift is up: 0 down, 1 up; NaN when the gripper cannot measure it; 0 without a lift
/// @param innerBeamBroken whether a thing is between the paddles, deep inside
/// @param outerBeamBroken whether a thing is between the paddles, near their tips
/// @param leftContact whether a thing touches the left paddle from inside
/// @param rightContact whether a thing touches the right paddle from inside
/// @param holding whether it has gripped a thing
public record GripperState(
        Paddles paddles,
        double closed,
        Lift lift,
        double raised,
        boolean innerBeamBroken,
        boolean outerBeamBroken,
        boolean leftContact,
        boolean rightContact,
        boolean holding) {

    /// What the paddles do.
    public enum Paddles {
        OPEN,
        /// As far as they go, which is less when they hold something.
        CLOSED,
        OPENING,
        CLOSING,
        /// Somewhere between: they were told to, or can't go on.
        STOPPED
    }

    /// What the lift does.
    public enum Lift {
        DOWN,
        UP,
        RISING,
        SINKING,
        /// Somewhere between: it was told to, or can't go on.
        STOPPED
    }
}
