package rsal.rtps.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/// Names a writer or reader within its participant: four octets, the last of which is its kind (DDSI-RTPS 2.5, table
/// 9.1 and 9.2).
///
/// @param octets as a big-endian number
public record EntityId(int octets) {
    public static final int BYTES = 4;

    /// All readers of a writer, or no one.
    public static final EntityId UNKNOWN = new EntityId(0);

    public static final EntityId PARTICIPANT = new EntityId(0x000001c1);
    public static final EntityId PARTICIPANT_WRITER = new EntityId(0x000100c2);
    public static final EntityId PARTICIPANT_READER = new EntityId(0x000100c7);
    public static final EntityId PUBLICATION_WRITER = new EntityId(0x000003c2);
    public static final EntityId PUBLICATION_READER = new EntityId(0x000003c7);
    public static final EntityId SUBSCRIPTION_WRITER = new EntityId(0x000004c2);
    public static final EntityId SUBSCRIPTION_READER = new EntityId(0x000004c7);
    public static final EntityId LIVELINESS_WRITER = new EntityId(0x000200c2);
    public static final EntityId LIVELINESS_READER = new EntityId(0x000200c7);

    private static final int WRITER_WITHOUT_KEY = 0x03;
    private static final int READER_WITHOUT_KEY = 0x04;
    private static final int GOLDEN = 0x9e3779b9; // 2^32 over the golden ratio: Fibonacci hashing (Knuth, TAOCP 3, 6.4)

    /// Of a topic without a key, as all topics of ROS are.
    public static EntityId writer(int number) {
        return new EntityId(number << 8 | WRITER_WITHOUT_KEY);
    }

    public static EntityId reader(int number) {
        return new EntityId(number << 8 | READER_WITHOUT_KEY);
    }

    static EntityId read(ByteBuffer bytes) {
        int octets = bytes.getInt();
        return new EntityId(bytes.order() == ByteOrder.BIG_ENDIAN ? octets : Integer.reverseBytes(octets));
    }

    void write(ByteBuffer bytes) {
        bytes.putInt(bytes.order() == ByteOrder.BIG_ENDIAN ? octets : Integer.reverseBytes(octets));
    }

    public boolean isWriter() {
        int kind = octets & 0x0f;
        return kind == 0x02 || kind == 0x03;
    }

    public boolean isReader() {
        int kind = octets & 0x0f;
        return kind == 0x04 || kind == 0x07;
    }

    /// Spreads ids that differ in their number only, which is above the last octet: hash tables look at the lowest
    /// bits.
    @Override
    public int hashCode() {
        int mixed = octets * GOLDEN;
        return mixed ^ mixed >>> 15; // hash tables themselves add 16
    }

    @Override
    public String toString() {
        return "%08x".formatted(octets);
    }
}
