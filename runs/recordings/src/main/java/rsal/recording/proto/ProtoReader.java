package rsal.recording.proto;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.recording.proto.MessageType.Field;
import rsal.recording.proto.MessageType.Kind;

/// Reads messages of any type, by its fields' names: as Double, Long, Boolean, String, `byte[]`, and Map for messages
/// within; as List where there can be many. What is left out has its default (0, empty); messages that are left out are
/// not there.
public final class ProtoReader {
    private static final int DEEPEST = 20;

    private ProtoReader() {}

    /// @throws IOException when it is no such message
    public static Map<String, Object> read(MessageType type, ByteBuffer message) throws IOException {
        return read(type, message.duplicate().order(ByteOrder.LITTLE_ENDIAN), 0);
    }

    private static Map<String, Object> read(MessageType type, ByteBuffer in, int depth) throws IOException {
        check(depth <= DEEPEST, type);
        var values = new LinkedHashMap<String, Object>();
        var lists = new HashMap<String, List<Object>>();
        for (Field field : type.fields()) {
            if (field.repeated()) {
                values.put(field.name(), lists.computeIfAbsent(field.name(), _ -> new ArrayList<>()));
            } else if (field.kind() != Kind.MESSAGE) {
                values.put(field.name(), nothing(field));
            }
        }
        while (in.hasRemaining()) {
            long tag = varint(in, type);
            int wire = (int) (tag & 7);
            ByteBuffer value = value(in, wire, type);
            Field field = type.field((int) (tag >>> 3)).orElse(null);
            if (field == null) {
                continue; // of a later version
            }
            if (field.repeated()) {
                List<Object> many = lists.computeIfAbsent(field.name(), _ -> new ArrayList<>());
                boolean isPacked = wire == 2
                        && field.kind() != Kind.MESSAGE
                        && field.kind() != Kind.STRING
                        && field.kind() != Kind.BYTES;
                do {
                    many.add(value(field, value, type, depth));
                } while (isPacked && value.hasRemaining());
            } else {
                values.put(field.name(), value(field, value, type, depth));
            }
        }
        return values;
    }

    private static Object nothing(Field field) {
        return switch (field.kind()) {
            case DOUBLE -> 0.0;
            case BOOL -> false;
            case STRING -> "";
            case ENUM -> field.words().getFirst();
            case BYTES -> new byte[0];
            default -> 0L;
        };
    }

    /// The bytes of the next value.
    private static ByteBuffer value(ByteBuffer in, int wire, MessageType type) throws IOException {
        int from = in.position();
        long length = switch (wire) {
            case 0 -> {
                varint(in, type);
                int bytes = in.position() - from;
                in.position(from);
                yield bytes;
            }
            case 1 -> 8;
            case 2 -> varint(in, type);
            case 5 -> 4;
            default -> -1;
        };
        check(length >= 0 && length <= in.remaining(), type);
        ByteBuffer value = in.slice(in.position(), (int) length).order(ByteOrder.LITTLE_ENDIAN);
        in.position(in.position() + (int) length);
        return value;
    }

    private static Object value(Field field, ByteBuffer in, MessageType type, int depth) throws IOException {
        return switch (field.kind()) {
            case DOUBLE -> {
                check(in.remaining() >= 8, type);
                yield in.getDouble();
            }
            case FIXED32 -> {
                check(in.remaining() >= 4, type);
                yield Integer.toUnsignedLong(in.getInt());
            }
            case INT64, UINT64, INT32 -> varint(in, type);
            case BOOL -> varint(in, type) != 0;
            case ENUM -> {
                long number = varint(in, type);
                yield number >= 0 && number < field.words().size()
                        ? field.words().get((int) number)
                        : Long.toString(number);
            }
            case STRING -> StandardCharsets.UTF_8.decode(in).toString();
            case BYTES -> {
                byte[] bytes = new byte[in.remaining()];
                in.get(bytes);
                yield bytes;
            }
            case MESSAGE -> read(field.type().orElseThrow(), in, depth + 1);
        };
    }

    private static long varint(ByteBuffer in, MessageType type) throws IOException {
        long value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            check(in.hasRemaining(), type);
            byte next = in.get();
            value |= (long) (next & 0x7f) << shift;
            if (next >= 0) {
                return value;
            }
        }
        throw new IOException("A number of a message '%s' does not end.".formatted(type.name()));
    }

    private static void check(boolean right, MessageType type) throws IOException {
        if (!right) {
            throw new IOException("A message is none of its kind '%s'.".formatted(type.name()));
        }
    }
}
