package rsal.rtps.wire;

import java.nio.ByteBuffer;

/// Numbers of a writer's samples: 64 bits, from 1 on, the high half first.
final class SequenceNumber {
    private SequenceNumber() {}

    static long read(ByteBuffer bytes) {
        long high = bytes.getInt();
        return (high << 32) | (bytes.getInt() & 0xffff_ffffL);
    }

    static void write(ByteBuffer bytes, long number) {
        bytes.putInt((int) (number >> 32)).putInt((int) number);
    }
}
