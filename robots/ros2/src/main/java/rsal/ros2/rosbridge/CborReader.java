package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/// Reads CBOR (RFC 8949). Arrays of numbers are views of the message's bytes. Nothing is allocated for what a
/// message claims to have but has not. Tags that are none of arrays are ignored.
final class CborReader {
    private static final int MOST_LEVELS = 64;
    private static final int UNSIGNED = 0; // major types
    private static final int NEGATIVE = 1;
    private static final int BYTES = 2;
    private static final int TEXT = 3;
    private static final int LIST = 4;
    private static final int MAP = 5;
    private static final int TAG = 6;
    private static final int ARGUMENT = 0b1_1111; // of the first byte
    private static final int ENDLESS = 31; // argument of what a break ends
    private static final int BREAK = 0xff;

    private final ByteBuffer in;

    private CborReader(ByteBuffer in) {
        this.in = in;
    }

    /// @param bytes of one value, from their position to their limit; not copied
    static Value read(ByteBuffer bytes) throws InvalidMessage {
        var reader = new CborReader(bytes.slice().order(ByteOrder.BIG_ENDIAN));
        Value value = reader.value(0);
        if (reader.in.hasRemaining()) {
            throw new InvalidMessage("%d bytes follow a value of CBOR.".formatted(reader.in.remaining()));
        }
        return value;
    }

    private Value value(int level) throws InvalidMessage {
        if (level > MOST_LEVELS) {
            throw new InvalidMessage("Values are nested more than %d levels deep.".formatted(MOST_LEVELS));
        }
        int first = unsigned8();
        int argument = first & ARGUMENT;
        return switch (first >> 5) {
            case UNSIGNED -> new Value.Int(argument(argument));
            case NEGATIVE -> negative(argument(argument));
            case BYTES -> new Value.Numbers(NumberArray.UINT8, string(argument, BYTES));
            case TEXT ->
                new Value.Text(
                        StandardCharsets.UTF_8.decode(string(argument, TEXT)).toString());
            case LIST -> new Value.Many(list(argument, level));
            case MAP -> new Value.Fields(map(argument, level));
            case TAG -> tagged(argument(argument), level);
            default -> simple(argument);
        };
    }

    private static Value negative(long argument) {
        return argument < 0 ? new Value.Real(-1 - unsigned(argument)) : new Value.Int(-1 - argument);
    }

    private static double unsigned(long bits) {
        return (bits >>> 1) * 2.0 + (bits & 1);
    }

    private Value tagged(long tag, int level) throws InvalidMessage {
        Value value = value(level + 1);
        return NumberArray.isTag(tag) && value instanceof Value.Numbers(int _, ByteBuffer bytes)
                ? new Value.Numbers((int) tag, bytes)
                : value;
    }

    private Value simple(int argument) throws InvalidMessage {
        return switch (argument) {
            case 20 -> new Value.Bool(false);
            case 21 -> new Value.Bool(true);
            case 22, 23 -> new Value.Null(); // null, undefined
            case 25 -> new Value.Real(Float.float16ToFloat(need(Short.BYTES).getShort()));
            case 26 -> new Value.Real(need(Float.BYTES).getFloat());
            case 27 -> new Value.Real(need(Double.BYTES).getDouble());
            default -> throw new InvalidMessage("Simple value %d of CBOR is not supported.".formatted(argument));
        };
    }

    private long argument(int argument) throws InvalidMessage {
        return switch (argument) {
            case 24 -> unsigned8();
            case 25 -> need(Short.BYTES).getShort() & 0xffffL;
            case 26 -> Integer.toUnsignedLong(need(Integer.BYTES).getInt());
            case 27 -> need(Long.BYTES).getLong();
            default -> {
                if (argument > 27) {
                    throw new InvalidMessage("Argument %d of CBOR is not supported.".formatted(argument));
                }
                yield argument;
            }
        };
    }

    private int unsigned8() throws InvalidMessage {
        return need(1).get() & 0xff;
    }

    private ByteBuffer need(int bytes) throws InvalidMessage {
        if (in.remaining() < bytes) {
            throw new InvalidMessage("The message ends within a value of CBOR.");
        }
        return in;
    }

    /// How many elements follow, each of which has at least so many bytes.
    private int count(int argument, int least) throws InvalidMessage {
        long count = argument(argument);
        if (count < 0 || count > in.remaining() / least) {
            throw new InvalidMessage("A value of CBOR claims to have %s elements, but only %d bytes follow."
                    .formatted(Long.toUnsignedString(count), in.remaining()));
        }
        return (int) count;
    }

    private ByteBuffer string(int argument, int type) throws InvalidMessage {
        if (argument == ENDLESS) {
            return chunks(type);
        }
        int count = count(argument, 1);
        ByteBuffer string = in.slice(in.position(), count);
        in.position(in.position() + count);
        return string;
    }

    private ByteBuffer chunks(int type) throws InvalidMessage {
        var all = ByteBuffer.allocate(in.remaining());
        while (!isBreak()) {
            int first = unsigned8();
            if (first >> 5 != type || (first & ARGUMENT) == ENDLESS) {
                throw new InvalidMessage("A string of CBOR has a part of another type.");
            }
            all.put(string(first & ARGUMENT, type));
        }
        return all.flip();
    }

    private boolean isBreak() throws InvalidMessage {
        need(1);
        boolean isBreak = (in.get(in.position()) & 0xff) == BREAK;
        if (isBreak) {
            in.get();
        }
        return isBreak;
    }

    private List<Value> list(int argument, int level) throws InvalidMessage {
        var all = new ArrayList<Value>();
        if (argument == ENDLESS) {
            while (!isBreak()) {
                all.add(value(level + 1));
            }
        } else {
            int count = count(argument, 1);
            for (int i = 0; i < count; i++) {
                all.add(value(level + 1));
            }
        }
        return all;
    }

    private Map<String, Value> map(int argument, int level) throws InvalidMessage {
        var all = new LinkedHashMap<String, Value>();
        if (argument == ENDLESS) {
            while (!isBreak()) {
                entry(all, level);
            }
        } else {
            int count = count(argument, 2);
            for (int i = 0; i < count; i++) {
                entry(all, level);
            }
        }
        return all;
    }

    private void entry(Map<String, Value> all, int level) throws InvalidMessage {
        if (!(value(level + 1) instanceof Value.Text(String name))) {
            throw new InvalidMessage("A key of CBOR must be a text.");
        }
        all.put(name, value(level + 1));
    }
}
