package rsal.device.imu;

import rsal.data.Angles;
import rsal.data.Perturbable;
import rsal.data.Unit;

/// A measurement of an IMU in the plane (`sensor_msgs/Imu` of ROS). It does not contain gravity, because robots
/// stand level.
///
/// @param orientation heading, counter-clockwise from east (REP 103) [rad]; without a compass, the start
/// heading plus the integrated rotation, so that it drifts
/// @param angularVelocity around the vertical axis, counter-clockwise [rad/s]; mean since the last reading
/// @param accelerationX ahead [m/s²]; mean since the last reading
/// @param accelerationY to the left [m/s²]; mean since the last reading
public record ImuReading(
        @Unit("rad") double orientation,
        @Unit("rad/s") double angularVelocity,
        @Unit("m/s²") double accelerationX,
        @Unit("m/s²") double accelerationY)
        implements Perturbable<ImuReading> {
    /// Of the orientation only.
    @Override
    public ImuReading withError(double range, double left, double angle) {
        return new ImuReading(Angles.wrap(orientation + angle), angularVelocity, accelerationX, accelerationY);
    }
}
