package rsal.ros2.rosbridge;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;

/// Writes CBOR for tests, as Python's `cbor` does.
final class CborWriter {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    /// A typed array of RFC 8746.
    record Tagged(int tag, byte[] bytes) {}

    static byte[] write(Object value) {
        var writer = new CborWriter();
        writer.value(value);
        return writer.out.toByteArray();
    }

    private void value(Object value) {
        switch (value) {
            case Boolean truth -> out.write(truth ? 0xf5 : 0xf4);
            case Long number -> head(number < 0 ? 1 : 0, number < 0 ? -1 - number : number);
            case Integer number -> value((long) number);
            case Double number -> {
                out.write(0xfb);
                out.writeBytes(ByteBuffer.allocate(8).putDouble(number).array());
            }
            case String text -> {
                byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
                head(3, bytes.length);
                out.writeBytes(bytes);
            }
            case byte[] bytes -> {
                head(2, bytes.length);
                out.writeBytes(bytes);
            }
            case Tagged(int tag, byte[] bytes) -> {
                head(6, tag);
                value(bytes);
            }
            case List<?> list -> {
                head(4, list.size());
                list.forEach(this::value);
            }
            case Map<?, ?> map -> {
                head(5, map.size());
                map.forEach((key, each) -> {
                    value(key);
                    value(each);
                });
            }
            default -> throw new IllegalArgumentException("Not in CBOR: " + value.getClass());
        }
    }

    private void head(int type, long argument) {
        if (argument >= 0 && argument < 24) {
            out.write(type << 5 | (int) argument);
        } else if (argument >= 0 && argument < 1 << 8) {
            out.write(type << 5 | 24);
            out.write((int) argument);
        } else if (argument >= 0 && argument < 1 << 16) {
            out.write(type << 5 | 25);
            out.writeBytes(ByteBuffer.allocate(2).putShort((short) argument).array());
        } else if (argument >= 0 && argument < 1L << 32) {
            out.write(type << 5 | 26);
            out.writeBytes(ByteBuffer.allocate(4).putInt((int) argument).array());
        } else {
            out.write(type << 5 | 27);
            out.writeBytes(ByteBuffer.allocate(8).putLong(argument).array());
        }
    }

    /// The bytes of numbers, little endian.
    static byte[] little(Object array) {
        return switch (array) {
            case byte[] all -> all;
            case short[] all -> {
                ByteBuffer bytes = buffer(2 * all.length);
                bytes.asShortBuffer().put(all);
                yield bytes.array();
            }
            case int[] all -> {
                ByteBuffer bytes = buffer(4 * all.length);
                bytes.asIntBuffer().put(all);
                yield bytes.array();
            }
            case long[] all -> {
                ByteBuffer bytes = buffer(8 * all.length);
                bytes.asLongBuffer().put(all);
                yield bytes.array();
            }
            case float[] all -> {
                ByteBuffer bytes = buffer(4 * all.length);
                bytes.asFloatBuffer().put(all);
                yield bytes.array();
            }
            case double[] all -> {
                ByteBuffer bytes = buffer(8 * all.length);
                bytes.asDoubleBuffer().put(all);
                yield bytes.array();
            }
            default -> throw new IllegalArgumentException("No numbers: " + array.getClass());
        };
    }

    private static ByteBuffer buffer(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }
}
