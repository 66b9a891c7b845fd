package rsal.data;

/// How a joint stands (one of `sensor_msgs/JointState`, one actuator of Player's `actarray`). Lengths in m when
/// it is linear, angles in rad when it is rotational.
///
/// @param position within its limits
/// @param speed towards larger positions when positive [m/s or rad/s]
/// @param limits of its position
public record ActuatorState(Joint joint, double position, double speed, Interval limits, Motion motion) {
    public enum Joint {
        LINEAR,
        ROTATIONAL
    }

    public enum Motion {
        IDLE,
        MOVING,
        /// It should move and does not.
        STALLED
    }
}
