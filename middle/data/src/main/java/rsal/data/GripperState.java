package rsal.data;

/// How a gripper stands (Player `gripper`, the lift as one joint of `actarray`, the beams as `dio`).
///
/// @param closed how far its paddles are closed: 0 open, 1 closed; NaN when it can't tell
/// @param raised how far its lift is up: 0 down, 1 up; NaN when it can't tell; 0 without a lift
/// @param innerBeamBroken whether something is between the paddles, deep inside
/// @param outerBeamBroken whether something is between the paddles, near their tips
/// @param leftContact whether something touches the left paddle from inside
/// @param rightContact whether something touches the right paddle from inside
/// @param holding whether it has gripped something
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

    public enum Paddles {
        OPEN,
        /// As far as they go, which is less when they hold something.
        CLOSED,
        OPENING,
        CLOSING,
        /// Somewhere between: they were told to, or can't go on.
        STOPPED
    }

    public enum Lift {
        DOWN,
        UP,
        RISING,
        SINKING,
        /// Somewhere between: it was told to, or can't go on.
        STOPPED
    }
}
