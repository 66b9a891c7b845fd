package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.sim.device.SimulatedSensor;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// Lets a device of a registered kind that casts rays look as laser scanners do.
final class SimRegisteredEye<T> extends SimRangeSensor<T> {
    private final SimulatedSensor<T> sensor;

    SimRegisteredEye(SimulatedSensor<T> sensor, Duration period, DeviceMount mount) {
        super(sensor.info(), sensor.frame(), period, mount);
        this.sensor = sensor;
        onHealth(sensor::isNow);
    }

    @Override
    int rays() {
        return sensor.rays();
    }

    @Override
    T measure(World world, Body robot, Instant now) {
        return sensor.measure(now);
    }

    @Override
    void reported(Stamped<T> reading) {
        sensor.show(reading);
    }

    @Override
    Device device() {
        return sensor;
    }
}
