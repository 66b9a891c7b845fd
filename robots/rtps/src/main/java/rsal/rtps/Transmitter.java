package rsal.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;

/// Sends datagrams. What gets lost is the protocol's business; so nothing is thrown.
public interface Transmitter {
    /// @param datagram from its position to its limit; used again afterwards
    void send(ByteBuffer datagram, InetSocketAddress to);

    /// Sends to all who may be there: the multicast group, and configured addresses.
    void announce(ByteBuffer datagram);
}
