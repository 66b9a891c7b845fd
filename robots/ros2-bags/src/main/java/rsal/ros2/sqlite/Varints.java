package rsal.ros2.sqlite;

import java.nio.ByteBuffer;

/// Numbers of one to nine bytes, one after the other: seven bits in each, the highest first, and eight in the ninth.
final class Varints {
    private static final int MOST_BYTES = 9;

    private final ByteBuffer bytes;
    private final int end;
    private int at;

    /// @param end behind the last byte that may be read
    Varints(ByteBuffer bytes, int at, int end) {
        this.bytes = bytes;
        this.at = at;
        this.end = end;
    }

    /// Of the next one.
    int position() {
        return at;
    }

    long next() throws InvalidSqlite {
        long value = 0;
        for (int i = 1; i <= MOST_BYTES; i++) {
            if (at < 0 || at >= end) {
                throw new InvalidSqlite("A number goes beyond its page");
            }
            int part = Byte.toUnsignedInt(bytes.get(at++));
            if (i == MOST_BYTES) {
                return value << Byte.SIZE | part;
            }
            value = value << 7 | (part & 0x7f);
            if (part < 0x80) {
                return value;
            }
        }
        throw new AssertionError("The ninth ends it.");
    }
}
