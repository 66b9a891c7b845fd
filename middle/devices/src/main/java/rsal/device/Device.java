package rsal.device;

import java.util.List;
import java.util.function.Consumer;

/// Something of a robot that can be asked or told.
public interface Device {
    DeviceInfo info();

    /// Devices that this one is made of, if they are of interest to anyone.
    default List<Device> children() {
        return List.of();
    }

    Health health();

    /// Tells of each change of health, not of how it is now.
    Subscription onHealth(Consumer<? super Health> listener);
}
