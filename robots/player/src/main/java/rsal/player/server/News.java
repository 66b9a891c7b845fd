package rsal.player.server;

import java.util.HashMap;
import java.util.Map;
import rsal.player.message.Protocol;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// New data of a device, which each client is told in the words of its version. Used by one thread at a time.
final class News {
    private final ServedDevice device;
    private final Address address;
    private final int subtype;
    private final double time;
    private final Record body;
    private final Map<Protocol, Packet> packets = new HashMap<>();

    /// @param time when it was measured, of the server's clock [s]
    /// @param body in the words of the newest version
    News(ServedDevice device, Address address, int subtype, double time, Record body) {
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
