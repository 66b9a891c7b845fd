package rsal.player.device;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import rsal.player.message.Interface;
import rsal.player.wire.Address;

/// What a server has.
///
/// @param devices in its order, without host and port
/// @param scanners those of its `ranger`s that turn: all their ranges are from one place
/// @param rings those that have a place for each range
record ServerOffer(List<Address> devices, List<Address> scanners, List<Address> rings) {
    ServerOffer {
        devices = List.copyOf(devices);
        scanners = List.copyOf(scanners);
        rings = List.copyOf(rings);
    }

    /// All that have an interface, by index.
    List<Address> of(Interface interf) {
        return devices.stream()
                .filter(device -> device.interf() == interf.code())
                .sorted(Comparator.comparingInt(Address::index))
                .toList();
    }

    /// For people: `position2d:0, ranger:0`.
    String words() {
        return devices.isEmpty()
                ? "nothing"
                : devices.stream().map(Interface::words).collect(Collectors.joining(", "));
    }
}
