package rsal.rtps.wire;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;

/// An address where a participant receives.
///
/// @param kind 1 for UDP over IPv4, which is the only one that is reached
/// @param port 1 to 65535 where it is reached
/// @param high the first eight octets of the address
/// @param low the last eight, of which IPv4 uses four
public record Locator(int kind, int port, long high, long low) {
    public static final int BYTES = 24;
    private static final int UDP_4 = 1;

    /// @throws IllegalArgumentException unless the address is of IPv4
    public static Locator udp(InetSocketAddress address) {
        if (!(address.getAddress() instanceof Inet4Address inet)) {
            throw new IllegalArgumentException("RTPS is spoken over IPv4 here, not to " + address);
        }
        return new Locator(
                UDP_4, address.getPort(), 0, ByteBuffer.wrap(inet.getAddress()).getInt() & 0xffff_ffffL);
    }

    public static Locator read(ByteBuffer bytes) {
        int kind = bytes.getInt();
        int port = bytes.getInt();
        ByteOrder order = bytes.order();
        bytes.order(ByteOrder.BIG_ENDIAN);
        var locator = new Locator(kind, port, bytes.getLong(), bytes.getLong());
        bytes.order(order);
        return locator;
    }

    public void write(ByteBuffer bytes) {
        bytes.putInt(kind).putInt(port);
        ByteOrder order = bytes.order();
        bytes.order(ByteOrder.BIG_ENDIAN).putLong(high).putLong(low).order(order);
    }

    /// Empty for what is no UDP over IPv4, or no address of one machine.
    public Optional<InetSocketAddress> unicast() {
        if (kind != UDP_4 || port <= 0 || port > 0xffff) {
            return Optional.empty();
        }
        try {
            byte[] octets = ByteBuffer.allocate(Integer.BYTES).putInt((int) low).array();
            InetAddress address = InetAddress.getByAddress(octets);
            boolean one = !address.isMulticastAddress() && !address.isAnyLocalAddress();
            return one ? Optional.of(new InetSocketAddress(address, port)) : Optional.empty();
        } catch (UnknownHostException e) {
            throw new AssertionError(e); // four octets are an address
        }
    }
}
