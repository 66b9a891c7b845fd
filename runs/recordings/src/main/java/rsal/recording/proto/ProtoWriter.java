package rsal.recording.proto;

import rsal.mcap.ByteSink;

/// Writes messages field by field into a sink that is kept: no field allocates anything. What has its default (0,
/// empty) is left out, as proto3 does. For one thread.
public final class ProtoWriter {
    private static final int VARINT = 0;
    private static final int FIXED64 = 1;
    private static final int LENGTH = 2;
    private static final int FIXED32 = 5;

    private final ByteSink sink;

    public ProtoWriter(ByteSink sink) {
        this.sink = sink;
    }

    public ByteSink sink() {
        return sink;
    }

    /// A new message.
    public void clear() {
        sink.clear();
    }

    private void tag(int field, int wire) {
        raw(field << 3 | wire);
    }

    private void raw(long value) {
        long left = value;
        while ((left & ~0x7fL) != 0) {
            sink.u8((int) (left & 0x7f) | 0x80);
            left >>>= 7;
        }
        sink.u8((int) left);
    }

    /// Of the kinds INT32, INT64, UINT64, ENUM.
    public void varint(int field, long value) {
        if (value != 0) {
            tag(field, VARINT);
            raw(value);
        }
    }

    public void bool(int field, boolean value) {
        varint(field, value ? 1 : 0);
    }

    public void number(int field, double value) {
        long bits = Double.doubleToRawLongBits(value);
        if (bits != 0) {
            tag(field, FIXED64);
            sink.u64(bits);
        }
    }

    public void fixed32(int field, int value) {
        if (value != 0) {
            tag(field, FIXED32);
            sink.u32(value);
        }
    }

    public void string(int field, String text) {
        if (!text.isEmpty()) {
            int at = begin(field);
            sink.characters(text);
            end(at);
        }
    }

    public void bytes(int field, byte[] bytes) {
        if (bytes.length > 0) {
            tag(field, LENGTH);
            raw(bytes.length);
            sink.raw(bytes);
        }
    }

    /// Repeated numbers, packed.
    public void numbers(int field, float[] values) {
        if (values.length > 0) {
            tag(field, LENGTH);
            raw(8L * values.length);
            for (float value : values) {
                sink.u64(Double.doubleToRawLongBits(value));
            }
        }
    }

    /// Repeated numbers, packed.
    public void numbers(int field, double... values) {
        if (values.length > 0) {
            tag(field, LENGTH);
            raw(8L * values.length);
            for (double value : values) {
                sink.u64(Double.doubleToRawLongBits(value));
            }
        }
    }

    /// Begins a message within; also an empty one is there.
    ///
    /// @return for [#end]
    public int begin(int field) {
        tag(field, LENGTH);
        sink.u8(0);
        return sink.size();
    }

    /// Ends the message within that was begun last.
    public void end(int begun) {
        int length = sink.size() - begun;
        int extra = 0; // bytes of the length beyond the first
        for (int left = length >>> 7; left != 0; left >>>= 7) {
            extra++;
        }
        if (extra > 0) {
            sink.insert(begun, extra);
        }
        int at = begun - 1;
        int left = length;
        for (int i = 0; i <= extra; i++) {
            sink.u8At(at + i, (left & 0x7f) | (i < extra ? 0x80 : 0));
            left >>>= 7;
        }
    }
}
