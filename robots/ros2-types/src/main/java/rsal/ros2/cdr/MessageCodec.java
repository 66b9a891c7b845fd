package rsal.ros2.cdr;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.ros2.type.Element;
import rsal.ros2.type.Field;
import rsal.ros2.type.FieldType;
import rsal.ros2.type.FieldType.Repeat;
import rsal.ros2.type.InvalidDefinition;
import rsal.ros2.type.Primitive;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;

/// Reads and writes messages of a type, as its definition says. Immutable, for any thread.
///
/// Tolerant as ROS 2 needs it: fields that are missing at the end of a message, as of an older peer, have zeros, and
/// bytes behind the last field are ignored.
public final class MessageCodec {
    private static final int MOST_LEVELS = 64; // of messages within messages

    private final RosType type;
    private final List<Slot> slots;

    /// A field, and how messages within it are read.
    private record Slot(Field field, List<MessageCodec> nested, int least) {
        MessageCodec codec() {
            return nested.getFirst();
        }

        /// Of its first byte. Fields of messages within are asked for themselves.
        int alignment() {
            if (field.type().isSequence()) {
                return Integer.BYTES;
            }
            return nested.isEmpty() ? least : 1;
        }
    }

    private MessageCodec(RosType type, List<Slot> slots) {
        this.type = type;
        this.slots = slots;
    }

    /// @param library has all types within
    /// @throws InvalidDefinition when it lacks one, or a type has itself within
    public static MessageCodec of(RosType type, TypeLibrary library) {
        return of(type, library, new HashMap<>(), 0);
    }

    private static MessageCodec of(RosType type, TypeLibrary library, Map<String, MessageCodec> known, int level) {
        if (level > MOST_LEVELS) {
            throw new InvalidDefinition(
                    "'%s' has messages within messages, more than %d levels deep.".formatted(type.name(), MOST_LEVELS));
        }
        var slots = new ArrayList<Slot>();
        for (Field field : type.fields()) {
            if (field.type().element() instanceof Element.Nested(String name)) {
                MessageCodec nested = known.get(name);
                if (nested == null) {
                    nested = of(library.get(name), library, known, level + 1);
                    known.put(name, nested);
                }
                slots.add(new Slot(field, List.of(nested), nested.least()));
            } else {
                slots.add(new Slot(field, List.of(), least(field.type().element())));
            }
        }
        return new MessageCodec(type, List.copyOf(slots));
    }

    private static int least(Element element) {
        return element instanceof Primitive primitive ? primitive.size() : Integer.BYTES;
    }

    /// Bytes that a message takes at least.
    private int least() {
        int sum = 0;
        for (Slot slot : slots) {
            FieldType field = slot.field().type();
            sum += field.isSequence() ? Integer.BYTES : slot.least() * Math.max(1, field.count());
        }
        return sum;
    }

    public RosType type() {
        return type;
    }

    /// @param payload with its encapsulation header
    public RosMessage read(byte[] payload) throws InvalidCdr {
        return read(CdrReader.of(payload));
    }

    /// Reads a message from where a reader stands.
    public RosMessage read(CdrReader in) throws InvalidCdr {
        var fields = LinkedHashMap.<String, Object>newLinkedHashMap(slots.size());
        for (Slot slot : slots) {
            fields.put(slot.field().name(), in.isAtEnd(slot.alignment()) ? zero(slot) : read(slot, in));
        }
        return new RosMessage(type, fields);
    }

    private static Object read(Slot slot, CdrReader in) throws InvalidCdr {
        FieldType field = slot.field().type();
        return switch (field.repeat()) {
            case ONE -> readOne(slot, in);
            case ARRAY -> readAll(slot, in, field.count());
            case ANY -> readAll(slot, in, in.count(slot.least()));
            case BOUNDED -> {
                int count = in.count(slot.least());
                if (count > field.count()) {
                    throw new InvalidCdr("Field '%s' has %d elements. At most %d are allowed."
                            .formatted(slot.field().name(), count, field.count()));
                }
                yield readAll(slot, in, count);
            }
        };
    }

    private static Object readOne(Slot slot, CdrReader in) throws InvalidCdr {
        return switch (slot.field().type().element()) {
            case Element.Nested _ -> slot.codec().read(in);
            case Element.Text(boolean isWide, int _) -> {
                if (isWide) {
                    throw new InvalidCdr("Field '%s' is a wstring, which implementations of ROS 2 write differently."
                            .formatted(slot.field().name()));
                }
                yield in.text();
            }
            case Primitive primitive ->
                switch (primitive) {
                    case BOOL -> in.bool();
                    case INT8 -> (long) in.int8();
                    case BYTE, UINT8 -> (long) (in.int8() & 0xff);
                    case INT16 -> (long) in.int16();
                    case UINT16 -> (long) (in.int16() & 0xffff);
                    case INT32 -> (long) in.int32();
                    case UINT32 -> Integer.toUnsignedLong(in.int32());
                    case INT64, UINT64 -> in.int64();
                    case FLOAT32 -> (double) in.float32();
                    case FLOAT64 -> in.float64();
                };
        };
    }

    private static Object readAll(Slot slot, CdrReader in, int count) throws InvalidCdr {
        return switch (slot.field().type().element()) {
            case Primitive primitive ->
                switch (primitive) {
                    case BOOL, BYTE, INT8, UINT8 -> in.int8s(count);
                    case INT16, UINT16 -> in.int16s(count);
                    case INT32, UINT32 -> in.int32s(count);
                    case INT64, UINT64 -> in.int64s(count);
                    case FLOAT32 -> in.float32s(count);
                    case FLOAT64 -> in.float64s(count);
                };
            case Element.Text _, Element.Nested _ -> {
                var all = new ArrayList<Object>(count);
                for (int i = 0; i < count; i++) {
                    all.add(readOne(slot, in));
                }
                yield List.copyOf(all);
            }
        };
    }

    /// A message with zeros, empty texts and empty sequences.
    public RosMessage zero() {
        var fields = LinkedHashMap.<String, Object>newLinkedHashMap(slots.size());
        slots.forEach(slot -> fields.put(slot.field().name(), zero(slot)));
        return new RosMessage(type, fields);
    }

    private static Object zero(Slot slot) {
        FieldType field = slot.field().type();
        if (field.repeat() == Repeat.ONE) {
            return zeroOne(slot);
        }
        int count = field.repeat() == Repeat.ARRAY ? field.count() : 0;
        return switch (field.element()) {
            case Primitive primitive ->
                switch (primitive) {
                    case BOOL, BYTE, INT8, UINT8 -> new byte[count];
                    case INT16, UINT16 -> new short[count];
                    case INT32, UINT32 -> new int[count];
                    case INT64, UINT64 -> new long[count];
                    case FLOAT32 -> new float[count];
                    case FLOAT64 -> new double[count];
                };
            case Element.Text _, Element.Nested _ -> Collections.nCopies(count, zeroOne(slot));
        };
    }

    private static Object zeroOne(Slot slot) {
        return switch (slot.field().type().element()) {
            case Element.Nested _ -> slot.codec().zero();
            case Element.Text _ -> "";
            case Primitive primitive ->
                switch (primitive) {
                    case BOOL -> false;
                    case FLOAT32, FLOAT64 -> 0.0;
                    default -> 0L;
                };
        };
    }

    /// The bytes of a message, with the encapsulation header.
    ///
    /// @throws IllegalArgumentException when it lacks a field, or one is of another type or too long
    public byte[] write(RosMessage message) {
        var out = new CdrWriter();
        write(message, out);
        return out.toBytes();
    }

    /// Writes a message behind what a writer has.
    public void write(RosMessage message, CdrWriter out) {
        for (Slot slot : slots) {
            Object value = message.fields().get(slot.field().name());
            if (value == null) {
                throw new IllegalArgumentException("A message of type '%s' lacks its field '%s'."
                        .formatted(type.name(), slot.field().name()));
            }
            try {
                write(slot, value, out);
            } catch (ClassCastException e) {
                throw new IllegalArgumentException(
                        "Field '%s' of '%s' can't be a %s."
                                .formatted(
                                        slot.field().name(),
                                        type.name(),
                                        value.getClass().getSimpleName()),
                        e);
            }
        }
    }

    private static void write(Slot slot, Object value, CdrWriter out) {
        FieldType field = slot.field().type();
        if (field.repeat() == Repeat.ONE) {
            writeOne(slot, value, out);
            return;
        }
        int count = count(value);
        boolean isWrong = (field.repeat() == Repeat.ARRAY && count != field.count())
                || (field.repeat() == Repeat.BOUNDED && count > field.count());
        if (isWrong) {
            throw new IllegalArgumentException("Field '%s' has %d elements instead of %s%d."
                    .formatted(
                            slot.field().name(),
                            count,
                            field.repeat() == Repeat.BOUNDED ? "at most " : "",
                            field.count()));
        }
        if (field.isSequence()) {
            out.int32(count);
        }
        writeAll(slot, value, out);
    }

    private static int count(Object value) {
        return value instanceof List<?> list ? list.size() : java.lang.reflect.Array.getLength(value);
    }

    private static void writeOne(Slot slot, Object value, CdrWriter out) {
        switch (slot.field().type().element()) {
            case Element.Nested _ -> slot.codec().write((RosMessage) value, out);
            case Element.Text _ -> out.text((String) value);
            case Primitive primitive -> {
                switch (primitive) {
                    case BOOL -> out.bool((Boolean) value);
                    case BYTE, INT8, UINT8 -> out.int8(((Long) value).byteValue());
                    case INT16, UINT16 -> out.int16(((Long) value).shortValue());
                    case INT32, UINT32 -> out.int32(((Long) value).intValue());
                    case INT64, UINT64 -> out.int64((Long) value);
                    case FLOAT32 -> out.float32(((Double) value).floatValue());
                    case FLOAT64 -> out.float64((Double) value);
                }
            }
        }
    }

    private static void writeAll(Slot slot, Object value, CdrWriter out) {
        switch (slot.field().type().element()) {
            case Element.Text _, Element.Nested _ -> ((List<?>) value).forEach(each -> writeOne(slot, each, out));
            case Primitive primitive -> {
                switch (primitive) {
                    case BOOL, BYTE, INT8, UINT8 -> out.int8s((byte[]) value);
                    case INT16, UINT16 -> out.int16s((short[]) value);
                    case INT32, UINT32 -> out.int32s((int[]) value);
                    case INT64, UINT64 -> out.int64s((long[]) value);
                    case FLOAT32 -> out.float32s((float[]) value);
                    case FLOAT64 -> out.float64s((double[]) value);
                }
            }
        }
    }
}
