package rsal.ros2.rosbridge;

import java.io.ByteArrayOutputStream;
import java.lang.reflect.Array;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
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
        int count = Array.getLength(array);
        ByteBuffer bytes = ByteBuffer.allocate(Double.BYTES * count).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < count; i++) {
            switch (Array.get(array, i)) {
                case Byte number -> bytes.put(number);
                case Short number -> bytes.putShort(number);
                case Integer number -> bytes.putInt(number);
                case Long number -> bytes.putLong(number);
                case Float number -> bytes.putFloat(number);
                case Double number -> bytes.putDouble(number);
                default -> throw new IllegalArgumentException("No numbers: " + array.getClass());
            }
        }
        return Arrays.copyOf(bytes.array(), bytes.position());
    }
}
