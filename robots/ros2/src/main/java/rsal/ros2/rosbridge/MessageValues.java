package rsal.ros2.rosbridge;

import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.type.Element;
import rsal.ros2.type.Field;
import rsal.ros2.type.FieldType;
import rsal.ros2.type.FieldType.Repeat;
import rsal.ros2.type.InvalidDefinition;
import rsal.ros2.type.Primitive;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;
import tools.jackson.core.JsonGenerator;

/// Messages as values of JSON and CBOR, by their definitions. Tolerant as two versions of ROS need it: fields
/// that are missing have zeros, those that are not known are ignored. Safe for several threads.
final class MessageValues {
    /// What stands for the fields of a type that has none.
    private static final String NOTHING = "structure_needs_at_least_one_member";

    private final TypeLibrary types;
    private final RosVersion version;
    private final Map<String, MessageCodec> codecs = new ConcurrentHashMap<>();

    MessageValues(TypeLibrary types, RosVersion version) {
        this.types = types;
        this.version = version;
    }

    RosVersion version() {
        return version;
    }

    private MessageCodec codec(String type) {
        MessageCodec known = codecs.get(type); // not computed within, as types have others within
        if (known == null) {
            known = MessageCodec.of(types.get(type), types);
            codecs.put(type, known);
        }
        return known;
    }

    /// The bytes in CDR of a message.
    ///
    /// @param type in full
    byte[] toCdr(String type, WireValue value) throws InvalidMessage {
        try {
            return codec(type).write(read(types.get(type), value));
        } catch (IllegalArgumentException | InvalidDefinition e) {
            // arrays of another length, and types that the server's distribution does not have
            throw new InvalidMessage(String.valueOf(e.getMessage()), e);
        }
    }

    /// @param type in full
    /// @throws IllegalArgumentException when the bytes are no such message
    /// @throws InvalidDefinition when the server's distribution does not have this type
    RosMessage ofCdr(String type, byte[] bytes) {
        try {
            return codec(type).read(bytes);
        } catch (InvalidCdr e) {
            throw new IllegalArgumentException("No message of type '%s': %s".formatted(type, e.getMessage()), e);
        }
    }

    private RosMessage read(RosType type, WireValue value) throws InvalidMessage {
        if (!(value instanceof WireValue.Fields(Map<String, WireValue> given))) {
            throw new InvalidMessage("A message of type '%s' can't be %s.".formatted(type.name(), value.words()));
        }
        var fields =
                LinkedHashMap.<String, Object>newLinkedHashMap(type.fields().size());
        for (Field field : type.fields()) {
            WireValue its = given.get(field.name());
            if (its == null) {
                its = given.get(RosVersion.other(field.name()));
            }
            fields.put(
                    field.name(),
                    its == null ? codec(type.name()).zero().fields().get(field.name()) : read(field, its));
        }
        return new RosMessage(type, fields);
    }

    private Object read(Field field, WireValue value) throws InvalidMessage {
        FieldType type = field.type();
        try {
            if (type.repeat() == Repeat.ONE) {
                return one(type.element(), value);
            }
            return switch (type.element()) {
                case Primitive primitive -> PrimitiveArrays.read(primitive, value);
                case Element.Text _, Element.Nested _ -> all(type.element(), value);
            };
        } catch (NotFitting e) {
            throw new InvalidMessage(
                    "Field '%s' can't be %s.".formatted(field.name(), e.value.words()), e); // the innermost says it
        }
    }

    private List<Object> all(Element element, WireValue value) throws InvalidMessage, NotFitting {
        if (!(value instanceof WireValue.Many(List<WireValue> values))) {
            throw new NotFitting(value);
        }
        var all = new ArrayList<Object>(values.size());
        for (WireValue each : values) {
            all.add(one(element, each));
        }
        return all;
    }

    private Object one(Element element, WireValue value) throws InvalidMessage, NotFitting {
        return switch (element) {
            case Element.Nested(String name) -> read(types.get(name), value);
            case Element.Text _ -> {
                if (!(value instanceof WireValue.Text(String text))) {
                    throw new NotFitting(value);
                }
                yield text;
            }
            case Primitive primitive -> number(primitive, value);
        };
    }

    private static Object number(Primitive primitive, WireValue value) throws NotFitting {
        return switch (primitive) {
            case BOOL -> PrimitiveArrays.integer(Primitive.BOOL, value) != 0;
            case FLOAT32, FLOAT64 -> PrimitiveArrays.real(value);
            case BYTE, INT8, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64 ->
                PrimitiveArrays.integer(primitive, value);
        };
    }

    /// A value that a field can't have.
    static final class NotFitting extends Exception {
        private static final long serialVersionUID = 1;
        private final transient WireValue value;

        NotFitting(WireValue value) {
            this.value = value;
        }
    }

    /// Writes a message as JSON. `uint8[]` are written in Base64, as rosbridge does.
    void write(RosMessage message, JsonGenerator out) {
        out.writeStartObject();
        for (Field field : message.type().fields()) {
            if (field.name().equals(NOTHING)) {
                continue; // rosbridge refuses fields that it does not know
            }
            out.writeName(version.wire(message.type().name(), field.name()));
            Object value = message.get(field.name(), Object.class);
            if (field.type().repeat() == Repeat.ONE) {
                writeOne(field.type().element(), value, out);
            } else {
                writeAll(field.type().element(), value, out);
            }
        }
        out.writeEndObject();
    }

    private void writeOne(Element element, Object value, JsonGenerator out) {
        switch (value) {
            case RosMessage nested -> write(nested, out);
            case String text -> out.writeString(text);
            case Boolean truth -> out.writeBoolean(truth);
            case Double number -> out.writeNumber(number);
            case Long number -> writeInteger(element, number, out);
            default -> throw new IllegalArgumentException("No field of a message: " + value.getClass());
        }
    }

    private static void writeInteger(Element element, long number, JsonGenerator out) {
        if (element == Primitive.UINT64 && number < 0) {
            out.writeNumber(new java.math.BigInteger(Long.toUnsignedString(number)));
        } else {
            out.writeNumber(number);
        }
    }

    private void writeAll(Element element, Object value, JsonGenerator out) {
        if (element == Primitive.UINT8 && value instanceof byte[] bytes) {
            out.writeString(Base64.getEncoder().encodeToString(bytes));
            return;
        }
        out.writeStartArray();
        if (value instanceof List<?> list) {
            list.forEach(each -> writeOne(element, each, out));
        } else {
            PrimitiveArrays.write((Primitive) element, value, out);
        }
        out.writeEndArray();
    }

    /// Whether servers can send a type as CBOR. They fail silently, and send nothing, for fixed arrays and
    /// lists of texts: in ROS 1 always (rosbridge_suite#864), in ROS 2 until February 2026 (#965, #1161). The
    /// covariance of `Odometry` is such an array.
    ///
    /// @param type in full
    boolean isForCbor(String type) {
        return types.find(type).stream()
                .flatMap(known -> known.fields().stream())
                .allMatch(field -> isForCbor(field.type()));
    }

    private boolean isForCbor(FieldType field) {
        return switch (field.element()) {
            case Element.Nested(String name) -> field.repeat() != Repeat.ARRAY && isForCbor(name);
            case Element.Text(boolean isWide, int _) -> !isWide && field.repeat() == Repeat.ONE;
            case Primitive primitive ->
                primitive != Primitive.BYTE && (field.repeat() == Repeat.ONE || field.repeat() == Repeat.ANY);
        };
    }
}
