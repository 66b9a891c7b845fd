package rsal.device.imu;

import rsal.data.Angles;
import rsal.data.Erring;
import rsal.data.Unit;

/// What an IMU measures in the plane, as `sensor_msgs/Imu` of ROS. Gravity is not in it, as robots stand level.
///
/// @param orientation heading, counter-clockwise from east (REP 103) [rad]; of an IMU without a compass, turned
///         since the start from the heading then, so that it drifts
/// @param angularVelocity around the vertical axis, counter-clockwise [rad/s]; mean since the last reading
/// @param accelerationX ahead [m/s²]; mean since the last reading
/// @param accelerationY to the left [m/s²]; mean since the last reading
public record ImuReading(
        @Unit("rad") double orientation,
        @Unit("rad/s") double angularVelocity,
        @Unit("m/s²") double accelerationX,
        @Unit("m/s²") double accelerationY)
        implements Erring<ImuReading> {
    /// Of the orientation only.
    @Override
    public ImuReading withError(double range, double left, double angle) {
        return new ImuReading(Angles.wrap(orientation + angle), angularVelocity, accelerationX, accelerationY);
    }
}
