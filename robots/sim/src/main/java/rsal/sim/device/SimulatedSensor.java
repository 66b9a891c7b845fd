package rsal.sim.device;

import java.time.Instant;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SensorCore;

/// A simulated sensor. It says what it measures; when it does, faults and health are the simulator's part. All calls
/// on the run's thread, after all robots have moved, except for sensors with [#rays].
public abstract class SimulatedSensor<T> extends SensorCore<T> {
    /// Frame of its readings: `<robot>/<device>` unless it says otherwise.
    private final String frame;

    protected SimulatedSensor(DeviceInfo info) {
        this(info, info.id());
    }

    protected SimulatedSensor(DeviceInfo info, String frame) {
        super(info);
        this.frame = frame;
    }

    public final String frame() {
        return frame;
    }

    /// How many rays a reading casts. A sensor that casts some may measure on another thread than the run's, beside
    /// others, and gets no [#step]. It must touch nothing that others touch.
    public int rays() {
        return 0;
    }

    /// One step of the simulation has passed. Called before [#measure].
    ///
    /// @param dt how long it was [s]
    public void step(double dt) {}

    /// What it reads now. Called when a reading is due.
    public abstract T measure(Instant now);

    /// Hands out a reading. The simulator calls it.
    public final void show(Stamped<T> reading) {
        deliver(reading);
    }

    /// Says how it is. The simulator calls it.
    public final void isNow(Health health) {
        health(health);
    }
}
