package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import rsal.device.DeviceInfo;
import rsal.robot.Shift;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// A sensor that looks into the distance, maybe on another thread than the run's.
abstract class SimRangeSensor<T> extends SimSensor<T> {
    private final DeviceMount mount;

    SimRangeSensor(DeviceInfo info, String frame, Duration period, DeviceMount mount) {
        super(info, frame, period);
        this.mount = mount;
    }

    /// How far it had been carried from where its model tells it to be, when the world was last looked at.
    final Shift shift() {
        return mount.seen();
    }

    /// How many rays a reading takes.
    abstract int rays();

    /// A reading of the world as it was last looked at. Touches nothing that others write meanwhile.
    abstract T measure(World world, Body robot, Instant now);

    final void look(World world, Body robot, Instant now) {
        take(measure(world, robot, now), now);
    }
}
