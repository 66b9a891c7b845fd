package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SensorCore;

/// What all that robots carry has in common: readings every now and then. Taking and telling them are apart, as many
/// look at once but tell one after the other.
abstract class SimSensor<T> extends SensorCore<T> {
    private final String frame;
    private final Duration period;
    private Instant due = Instant.MIN;
    private @Nullable Stamped<T> taken;

    SimSensor(DeviceInfo info, String frame, Duration period) {
        super(info);
        this.frame = frame;
        this.period = period;
    }

    /// Whether it is time for a reading: the first at once, then one a period, but not more than one a step.
    final boolean isDue(Instant now) {
        return !now.isBefore(due);
    }

    /// Takes a reading when it is due.
    final void take(T value, Instant now) {
        takeNow(value, now);
        Instant next = due.equals(Instant.MIN) ? now.plus(period) : due.plus(period);
        due = next.isBefore(now) ? now : next;
    }

    /// Takes a reading besides those that are due.
    final void takeNow(T value, Instant now) {
        taken = new Stamped<>(now, frame, value);
    }

    /// Tells of the reading, if one was taken since the last time.
    final void report() {
        Stamped<T> reading = taken;
        if (reading != null) {
            taken = null;
            deliver(reading);
            told(reading);
        }
    }

    /// What else to do with a reading that was told.
    void told(Stamped<T> reading) {}

    void close(Health.Lost why) {
        taken = null; // whoever closed may have been told by another device of this very robot
        health(why);
    }
}
