package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SensorCore;
import rsal.sim.world.Body;
import rsal.sim.world.World;

/// What laser scanners and sonars have in common: they look every now and then, and what they measure is noisy.
/// Looking and telling are apart, as many look at once but tell one after the other.
abstract class RangeSensor<T> extends SensorCore<T> {
    private final String frame;
    private final Duration period;
    private final Noise noise;
    private Instant due = Instant.MIN;
    private @Nullable Stamped<T> seen;

    RangeSensor(DeviceInfo info, String frame, Duration period, Noise noise) {
        super(info);
        this.frame = frame;
        this.period = period;
        this.noise = noise;
    }

    /// How many rays a reading takes.
    abstract int rays();

    abstract T measure(World world, Body robot);

    /// Whether it is time for a reading: the first at once, then one a period, but not more than one a step.
    boolean isDue(Instant now) {
        return !now.isBefore(due);
    }

    /// Takes a reading. Touches nothing that others write meanwhile.
    void look(World world, Body robot, Instant now) {
        seen = new Stamped<>(now, frame, measure(world, robot));
        Instant next = due.equals(Instant.MIN) ? now.plus(period) : due.plus(period);
        due = next.isBefore(now) ? now : next;
    }

    /// Tells of the reading, if one was taken since the last time.
    void report() {
        Stamped<T> reading = seen;
        if (reading != null) {
            seen = null;
            deliver(reading);
        }
    }

    void close(Health.Lost why) {
        seen = null; // whoever closed may have been told by another device of this very robot
        health(why);
    }

    /// A true range [m], as the sensor shows it (REP 117).
    float shown(double range, double min, double max) {
        if (range > max) {
            return Float.POSITIVE_INFINITY;
        }
        double noisy = range + noise.next();
        if (range < min || noisy < min) {
            return Float.NEGATIVE_INFINITY;
        }
        return noisy > max ? Float.POSITIVE_INFINITY : (float) noisy;
    }

    /// Errors of ranges [m].
    ///
    /// @param deviation standard deviation [m]
    record Noise(double deviation, RandomGenerator random) {
        double next() {
            return deviation * random.nextGaussian();
        }
    }
}
