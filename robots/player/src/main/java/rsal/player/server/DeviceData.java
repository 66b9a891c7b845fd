package rsal.player.server;

import java.util.HashMap;
import java.util.Map;
import rsal.player.message.Protocol;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// New data of a device, which each client gets in the messages of its version. Used by one thread at a time.
final class DeviceData {
    private final ServedDevice device;
    private final Address address;
    private final int subtype;
    private final double time;
    private final Record body;
    private final Map<Protocol, Packet> packets = new HashMap<>();

    /// @param time when it was measured, of the server's clock [s]
    /// @param body as a message of the newest version
    DeviceData(ServedDevice device, Address address, int subtype, double time, Record body) {
        this.device = device;
        this.address = address;
        this.subtype = subtype;
        this.time = time;
        this.body = body;
    }

    ServedDevice device() {
        return device;
    }

    Packet in(Protocol protocol) {
        return packets.computeIfAbsent(
                protocol, words -> Packet.of(address, MessageKind.DATA, subtype, time, words.worded(body)));
    }
}
