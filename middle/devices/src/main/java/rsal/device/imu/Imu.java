package rsal.device.imu;

import rsal.device.Sensor;

/// An inertial measurement unit (IMU). Frame of its readings: `<robot>/<device>`.
public interface Imu extends Sensor<ImuReading> {}
