package rsal.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.function.Consumer;

/// What every device needs and drivers need not write again: who it is and how it is.
public abstract class DeviceCore implements Device {
    private static final Logger LOG = System.getLogger(Device.class.getName());

    private final DeviceInfo info;
    private final Listeners<Health> healthListeners;
    private Health health = Health.ok(); // as listeners know it
    private Health seen = Health.ok(); // by the driver
    private Optional<Health> reported = Optional.empty(); // by others

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

    /// For drivers: how the device is from now on, as far as the driver sees it.
    protected final void health(Health now) {
        seen = now;
        settle();
    }

    /// For robot systems: how others report the device to be, such as the robot's own diagnostics. The worse of what
    /// they report and what the driver sees counts; where both are equally bad, what they report, as it says why.
    ///
    /// @param now empty when they report nothing
    public final void report(Optional<Health> now) {
        reported = now;
        settle();
    }

    private void settle() {
        Health now = reported.filter(other -> severity(other) >= severity(seen)).orElse(seen);
        if (!now.equals(health)) {
            health = now;
            healthListeners.publish(now);
        }
    }

    private static int severity(Health health) {
        return switch (health) {
            case Health.Ok _ -> 0;
            case Health.Stale _ -> 1;
            case Health.Lost _ -> 2;
        };
    }

    /// For drivers: what to do when a listener of this device throws.
    protected static Consumer<RuntimeException> reportFailure(DeviceInfo info) {
        return e -> LOG.log(
                Level.ERROR, () -> "A listener of '%s' failed and is not notified any more.".formatted(info.id()), e);
    }
}
