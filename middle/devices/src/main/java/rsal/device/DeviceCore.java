package rsal.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.Consumer;

/// What every device needs and drivers need not write again: who it is and how it is.
public abstract class DeviceCore implements Device {
    private static final Logger LOG = System.getLogger(Device.class.getName());

    private final DeviceInfo info;
    private final Listeners<Health> healthListeners;
    private Health health = Health.ok();

    protected DeviceCore(DeviceInfo info) {
        this.info = info;
        this.healthListeners = new Listeners<>(reportFailure(info));
    }

    @Override
    public final DeviceInfo info() {
        return info;
    }

    @Override
    public final Health health() {
        return health;
    }

    @Override
    public final Subscription onHealth(Consumer<? super Health> listener) {
        return healthListeners.add(listener);
    }

    /// For drivers: how the device is from now on.
    protected final void health(Health now) {
        if (!now.equals(health)) {
            health = now;
            healthListeners.tell(now);
        }
    }

    /// For drivers: what to do when a listener of this device throws.
    protected static Consumer<RuntimeException> reportFailure(DeviceInfo info) {
        return e -> LOG.log(
                Level.ERROR, () -> "A listener of '%s' failed and is not notified any more.".formatted(info.id()), e);
    }
}
