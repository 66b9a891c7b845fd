package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.SensorCore;
import rsal.device.Subscription;
import rsal.fault.Fault;
import rsal.fault.SensorFaults;

/// What all that robots carry has in common: readings every now and then. Taking and telling them are apart, as many
/// look at once but tell one after the other.
abstract class SimSensor<T> extends SensorCore<T> {
    private static final int PATIENCE = 3; // periods without a reading, then it is stale

    private final String frame;
    private final Duration period;
    private final SensorFaults<T> faults = new SensorFaults<>();
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
            faults.shown(reading).ifPresentOrElse(this::publish, () -> isSilent(reading.time()));
        }
    }

    private void publish(Stamped<T> reading) {
        deliver(reading);
        reported(reading);
    }

    private void isSilent(Instant now) {
        Duration limit = period.multipliedBy(PATIENCE);
        if (latest().filter(last -> now.isBefore(last.time().plus(limit))).isEmpty()) {
            health(new Health.Stale("No reading for %d ms.".formatted(limit.toMillis())));
        }
    }

    /// Begins a fault.
    ///
    /// @return ends it
    final Subscription begin(Fault.OfSensor fault, RandomGenerator random) {
        return faults.add(fault, random);
    }

    /// What agents get to see of it.
    Device device() {
        return this;
    }

    /// What else to do with a reading that was told.
    void reported(Stamped<T> reading) {}

    void close(Health.Lost why) {
        taken = null; // the one that closed may have been told by another device of this very robot
        health(why);
    }
}
