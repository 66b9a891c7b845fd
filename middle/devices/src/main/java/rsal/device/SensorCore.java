package rsal.device;

import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.data.Stamped;

/// What every sensor needs and drivers need not write again: the newest reading and those who want each.
public abstract class SensorCore<T> extends DeviceCore implements Sensor<T> {
    private final Listeners<Stamped<T>> listeners;
    private @Nullable Stamped<T> latest;

    protected SensorCore(DeviceInfo info) {
        super(info);
        this.listeners = new Listeners<>(reportFailure(info));
    }

    @Override
    public final Optional<Stamped<T>> latest() {
        return Optional.ofNullable(latest);
    }

    @Override
    public final Subscription subscribe(Consumer<? super Stamped<T>> listener) {
        return listeners.add(listener);
    }

    /// For drivers: a new reading. A device that was stale or lost is well again.
    protected final void deliver(Stamped<T> reading) {
        latest = reading;
        health(Health.ok());
        listeners.publish(reading);
    }
}
