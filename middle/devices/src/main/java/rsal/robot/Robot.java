package rsal.robot;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import rsal.device.Device;

/// A robot is its devices.
///
/// @param id unique in a run
/// @param role what the scenario calls robots of its kind (`hunter`)
/// @param marker id of the marker that it wears, by which fiducial finders know it
/// @param devices in the order in which they were made: hardware first, then software devices, each from those
/// before it
public record Robot(String id, String role, RobotModel model, OptionalInt marker, List<Device> devices) {
    public Robot {
        devices = List.copyOf(devices);
    }

    /// A robot that wears no marker.
    public Robot(String id, String role, RobotModel model, List<Device> devices) {
        this(id, role, model, OptionalInt.empty(), devices);
    }

    /// The first device of a type.
    public <D extends Device> Optional<D> find(Class<D> type) {
        for (Device device : devices) { // a stream takes as long as all else that is asked of a robot for a picture
            if (type.isInstance(device)) {
                return Optional.of(type.cast(device));
            }
        }
        return Optional.empty();
    }

    /// @throws IllegalStateException when the robot has none
    public <D extends Device> D require(Class<D> type) {
        return find(type)
                .orElseThrow(() -> new IllegalStateException(
                        "Robot '%s' has no %s; it has %s. Maybe its model '%s' or the scenario should name one."
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
        return with(Stream.concat(devices.stream(), Stream.of(device)).toList());
    }

    /// The same robot with another device in place of one.
    public Robot replacing(Device old, Device other) {
        return with(devices.stream()
                .map(device -> device.equals(old) ? other : device)
                .toList());
    }

    /// The same robot with these devices in place of all that it has.
    public Robot with(List<Device> others) {
        return new Robot(id, role, model, marker, others);
    }
}
