package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import rsal.device.DeviceInfo;

/// Something on a robot that feels or moves with each step, on the run's thread, when all robots have moved.
abstract class SimActuatedDevice<T> extends SimSensor<T> {
    SimActuatedDevice(DeviceInfo info, String frame, Duration period) {
        super(info, frame, period);
    }

    /// One step on.
    ///
    /// @param dt [s]
    abstract void work(Instant now, double dt);
}
