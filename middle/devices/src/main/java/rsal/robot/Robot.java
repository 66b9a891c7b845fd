package rsal.robot;

import java.util.List;
import java.util.Optional;
import rsal.device.Device;

/// A robot is its devices.
///
/// @param id unique in a run
/// @param role what the scenario calls robots of its kind (`hunter`)
/// @param devices in the order in which they were made: hardware first, then software devices, each from those
/// before it
public record Robot(String id, String role, RobotModel model, List<Device> devices) {
    public Robot {
        devices = List.copyOf(devices);
    }

    /// The first device of a type.
    public <D extends Device> Optional<D> find(Class<D> type) {
        return devices.stream().filter(type::isInstance).map(type::cast).findFirst();
    }

    /// @throws IllegalStateException when the robot has none
    public <D extends Device> D require(Class<D> type) {
        return find(type)
                .orElseThrow(() -> new IllegalStateException(
                        "Robot (%s) has no %s; it has %s. Maybe its model (%s) or the scenario should name one."
                                .formatted(
                                        id,
                                        type.getSimpleName(),
                                        devices.stream()
                                                .map(d -> d.info().name())
                                                .toList(),
                                        model.name())));
    }

    /// The same robot with one more device.
    public Robot with(Device device) {
        return new Robot(
                id,
                role,
                model,
                java.util.stream.Stream.concat(devices.stream(), java.util.stream.Stream.of(device))
                        .toList());
    }

    /// The same robot with another device in place of one.
    public Robot replacing(Device old, Device other) {
        return new Robot(
                id,
                role,
                model,
                devices.stream()
                        .map(device -> device.equals(old) ? other : device)
                        .toList());
    }
}
