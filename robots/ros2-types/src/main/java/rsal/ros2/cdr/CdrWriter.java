package rsal.ros2.cdr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/// Writes a message as bytes, value after value: XCDR1, little endian, as all ROS 2 in use does. Grows as needed,
/// and can be used again. Of one thread.
public final class CdrWriter {
    private static final int HEADER = 4;
    private static final byte LITTLE_ENDIAN = 1;
    private static final int FIRST_CAPACITY = 256;

    private byte[] array = new byte[FIRST_CAPACITY];
    private ByteBuffer bytes = buffer(array); // over the array

    public CdrWriter() {
        clear();
    }

    private static ByteBuffer buffer(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    /// Begins another message.
    public CdrWriter clear() {
        bytes.clear().put((byte) 0).put(LITTLE_ENDIAN).put((byte) 0).put((byte) 0);
        return this;
    }

    /// What was written, with the encapsulation header.
    public byte[] toBytes() {
        return Arrays.copyOf(array, bytes.position());
    }

    public CdrWriter bool(boolean value) {
        return int8((byte) (value ? 1 : 0));
    }

    public CdrWriter int8(byte value) {
        room(1, 1).put(value);
        return this;
    }

    public CdrWriter int16(short value) {
        room(2, 2).putShort(value);
        return this;
    }

    public CdrWriter int32(int value) {
        room(4, 4).putInt(value);
        return this;
    }

    public CdrWriter int64(long value) {
        room(8, 8).putLong(value);
        return this;
    }

    public CdrWriter float32(float value) {
        room(4, 4).putFloat(value);
        return this;
    }

    public CdrWriter float64(double value) {
        room(8, 8).putDouble(value);
        return this;
    }

    /// A text of UTF-8, which a zero ends.
    public CdrWriter text(String text) {
        byte[] encoded = text.getBytes(StandardCharsets.UTF_8);
        int32(encoded.length + 1);
        room(1, encoded.length + 1).put(encoded).put((byte) 0);
        return this;
    }

    /// Elements of an array or, behind its count, of a sequence.
    public CdrWriter int8s(byte[] values) {
        room(1, values.length).put(values);
        return this;
    }

    public CdrWriter int16s(short[] values) {
        elements(2, values.length).asShortBuffer().put(values);
        return this;
    }

    public CdrWriter int32s(int[] values) {
        elements(4, values.length).asIntBuffer().put(values);
        return this;
    }

    public CdrWriter int64s(long[] values) {
        elements(8, values.length).asLongBuffer().put(values);
        return this;
    }

    public CdrWriter float32s(float[] values) {
        elements(4, values.length).asFloatBuffer().put(values);
        return this;
    }

    public CdrWriter float64s(double[] values) {
        elements(8, values.length).asDoubleBuffer().put(values);
        return this;
    }

    /// The room of so many elements, which counts as written.
    private ByteBuffer elements(int size, int count) {
        ByteBuffer room = room(size, size * count);
        int begin = room.position();
        room.position(begin + size * count);
        return room.slice(begin, size * count).order(room.order());
    }

    /// Fills up with zeros to a multiple of a size, and grows for what follows. Nothing aligns nothing.
    private ByteBuffer room(int alignment, int size) {
        if (size == 0) {
            return bytes;
        }
        int at = bytes.position() - HEADER;
        int padding = -at & (alignment - 1);
        if (bytes.remaining() < padding + size) {
            int wanted = Math.addExact(bytes.position() + padding, size);
            array = Arrays.copyOf(array, Math.max(wanted, 2 * array.length));
            bytes = buffer(array).position(bytes.position());
        }
        for (int i = 0; i < padding; i++) {
            bytes.put((byte) 0);
        }
        return bytes;
    }
}
