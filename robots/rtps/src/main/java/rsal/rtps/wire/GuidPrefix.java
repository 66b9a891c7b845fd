package rsal.rtps.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/// Names a participant: 12 octets, unique on the network.
///
/// @param high the first eight octets, as a big-endian number; the first two are the vendor's
/// @param low the last four
public record GuidPrefix(long high, int low) {
    public static final int BYTES = 12;

    /// Where a message is for everybody.
    public static final GuidPrefix UNKNOWN = new GuidPrefix(0, 0);

    /// @param bytes whose order is not used
    static GuidPrefix read(ByteBuffer bytes) {
        ByteOrder order = bytes.order();
        bytes.order(ByteOrder.BIG_ENDIAN);
        var prefix = new GuidPrefix(bytes.getLong(), bytes.getInt());
        bytes.order(order);
        return prefix;
    }

    void write(ByteBuffer bytes) {
        ByteOrder order = bytes.order();
        bytes.order(ByteOrder.BIG_ENDIAN).putLong(high).putInt(low).order(order);
    }

    /// Of the DDS implementation, 0x0110 for Cyclone DDS.
    public int vendor() {
        return (int) (high >>> 48);
    }

    @Override
    public String toString() {
        return "%016x%08x".formatted(high, low);
    }
}
