package rsal.mcap;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;

/// Bytes in the making: little-endian, and larger when need be. Kept from message to message, it allocates nothing
/// once it is large enough. For one thread.
public final class ByteSink {
    private byte[] array;
    private ByteBuffer bytes; // the same

    /// @param capacity to begin with [B]
    public ByteSink(int capacity) {
        array = new byte[capacity];
        bytes = ByteBuffer.wrap(array).order(ByteOrder.LITTLE_ENDIAN);
    }

    public int size() {
        return bytes.position();
    }

    public void clear() {
        bytes.clear();
    }

    /// What is in it; its own array, so valid until the next change.
    public ByteBuffer written() {
        return bytes.duplicate().order(ByteOrder.LITTLE_ENDIAN).flip();
    }

    /// A copy of what is in it.
    public byte[] toArray() {
        byte[] copy = new byte[size()];
        written().get(copy);
        return copy;
    }

    byte[] array() {
        return array;
    }

    /// Makes place for so many bytes more.
    ///
    /// @throws IllegalStateException when that would be more than an array can have
    public void reserve(int more) {
        if (bytes.remaining() < more) {
            long wanted = Math.max(2L * array.length, (long) size() + more);
            if ((long) size() + more > Integer.MAX_VALUE - 16) {
                throw new IllegalStateException("A record of more than 2 GB can't be made.");
            }
            int size = size();
            array = Arrays.copyOf(array, (int) Math.min(wanted, Integer.MAX_VALUE - 16));
            bytes = ByteBuffer.wrap(array).order(ByteOrder.LITTLE_ENDIAN).position(size);
        }
    }

    public ByteSink u8(int value) {
        reserve(1);
        bytes.put((byte) value);
        return this;
    }

    public ByteSink u16(int value) {
        reserve(2);
        bytes.putShort((short) value);
        return this;
    }

    public ByteSink u32(int value) {
        reserve(4);
        bytes.putInt(value);
        return this;
    }

    public ByteSink u64(long value) {
        reserve(8);
        bytes.putLong(value);
        return this;
    }

    public ByteSink raw(byte[] some) {
        return raw(some, 0, some.length);
    }

    public ByteSink raw(byte[] some, int from, int count) {
        reserve(count);
        bytes.put(some, from, count);
        return this;
    }

    public ByteSink raw(ByteBuffer some) {
        reserve(some.remaining());
        bytes.put(some.duplicate());
        return this;
    }

    /// The characters alone, in UTF-8.
    public ByteSink characters(String text) {
        reserve(text.length());
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c >= 0x80) {
                return raw(text.substring(i).getBytes(StandardCharsets.UTF_8));
            }
            bytes.put((byte) c);
        }
        return this;
    }

    /// As MCAP has it: the length in bytes first.
    public ByteSink string(String text) {
        int at = size();
        u32(0).characters(text);
        return lengthAt(at);
    }

    /// As MCAP has it: the length in bytes first.
    ByteSink map(Map<String, String> entries) {
        int at = size();
        u32(0);
        entries.forEach((key, value) -> string(key).string(value));
        return lengthAt(at);
    }

    private ByteSink lengthAt(int at) {
        return u32At(at, size() - at - Integer.BYTES);
    }

    /// Writes over what was written before.
    ByteSink u32At(int at, int value) {
        bytes.putInt(at, value);
        return this;
    }

    ByteSink u64At(int at, long value) {
        bytes.putLong(at, value);
        return this;
    }

    /// Makes place for `count` bytes at `at`, by moving on what comes after.
    public void insert(int at, int count) {
        reserve(count);
        System.arraycopy(array, at, array, at + count, size() - at);
        bytes.position(size() + count);
    }

    /// Writes over what was written before.
    public void u8At(int at, int value) {
        bytes.put(at, (byte) value);
    }
}
