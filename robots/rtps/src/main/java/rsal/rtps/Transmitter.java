package rsal.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Set;

/// Sends datagrams. What gets lost is the protocol's business; so nothing is thrown.
public interface Transmitter {
    /// @param datagram from its position to its limit; used again afterwards
    void send(ByteBuffer datagram, InetSocketAddress to);

    /// Sends to all who may be there: the multicast group, and addresses where somebody may listen.
    ///
    /// @param known addresses of participants that hear the multicast group, where there is one. They need
    ///     no datagram of their own
    void announce(ByteBuffer datagram, Set<InetSocketAddress> known);
}
