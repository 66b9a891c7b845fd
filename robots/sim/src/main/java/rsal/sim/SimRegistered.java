package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.sim.device.SimulatedSensor;

/// Lets a device of a registered kind work as those do that the simulator knows: periods, faults, health.
final class SimRegistered<T> extends SimActuatedDevice<T> {
    private final SimulatedSensor<T> sensor;

    SimRegistered(SimulatedSensor<T> sensor, Duration period) {
        super(sensor.info(), sensor.frame(), period);
        this.sensor = sensor;
        onHealth(sensor::isNow);
    }

    @Override
    void work(Instant now, double dt) {
        sensor.step(dt);
        if (isDue(now)) {
            take(sensor.measure(now), now);
        }
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
