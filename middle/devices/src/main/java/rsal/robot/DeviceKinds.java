package rsal.robot;

import java.util.Collection;
import java.util.Optional;
import java.util.ServiceLoader;
import rsal.device.Device;
import rsal.settings.PluginKind;

/// The [DeviceKind]s that are installed.
public final class DeviceKinds {
    private static final PluginKind INSTALLED =
            PluginKind.of("deviceKind", DeviceKind.class, ServiceLoader.load(DeviceKind.class));

    private DeviceKinds() {}

    /// In the order of their keys.
    public static Collection<DeviceKind> all() {
        return INSTALLED.all().stream().map(DeviceKind.class::cast).toList();
    }

    public static Optional<DeviceKind> find(String key) {
        return INSTALLED.find(key).map(DeviceKind.class::cast);
    }

    /// The kind whose contract a class fulfils.
    public static Optional<DeviceKind> of(Class<? extends Device> type) {
        return all().stream()
                .filter(kind -> kind.makes().isAssignableFrom(type))
                .findFirst();
    }
}
