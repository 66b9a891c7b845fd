package rsal.data;

/// State of a joint (an element of `sensor_msgs/JointState`, an actuator of Player's `actarray`). Lengths in m
/// when the joint is linear, angles in rad when it is rotational.
///
/// @param joint whether it is linear or rotational
/// @param position within its limits [m or rad]
/// @param speed towards larger positions when positive [m/s or rad/s]
/// @param limits of its position [m or rad]
/// @param motion what it does now
public record ActuatorState(Joint joint, double position, double speed, Interval limits, Motion motion) {
    /// How a joint moves: its positions are in m or in rad.
    public enum Joint {
        LINEAR,
        ROTATIONAL
    }

    /// What a joint does.
    public enum Motion {
        IDLE,
        MOVING,
        /// It should move and does not.
        STALLED
    }
}
