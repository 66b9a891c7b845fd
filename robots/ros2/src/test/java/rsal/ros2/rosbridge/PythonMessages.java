package rsal.ros2.rosbridge;

import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Map.Entry;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.type.Element;
import rsal.ros2.type.Field;
import rsal.ros2.type.FieldType.Repeat;
import rsal.ros2.type.Primitive;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/// Messages as a server of rosbridge has them, with its weaknesses: what is NaN or infinite is `null` in
/// JSON, CBOR has no fixed arrays, and fields that a type does not have are refused. Written apart from what
/// it tests.
final class PythonMessages {
    private static final String NOTHING = "structure_needs_at_least_one_member";

    private final TypeLibrary types;
    private final boolean isRos1;

    /// What the server says when it can't have a message.
    static final class Refused extends Exception {
        private static final long serialVersionUID = 1;

        Refused(String message) {
            super(message);
        }
    }

    PythonMessages(TypeLibrary types, boolean isRos1) {
        this.types = types;
        this.isRos1 = isRos1;
    }

    RosMessage ofCdr(String type, byte[] bytes) {
        try {
            return MessageCodec.of(types.get(type), types).read(bytes);
        } catch (InvalidCdr e) {
            throw new AssertionError(e);
        }
    }

    byte[] toCdr(RosMessage message) {
        return MessageCodec.of(message.type(), types).write(message);
    }

    private String name(RosType type, Field field) {
        boolean isTime = isRos1 && type.name().matches("builtin_interfaces/msg/(Time|Duration)");
        return isTime ? Map.of("sec", "secs", "nanosec", "nsecs").get(field.name()) : field.name();
    }

    private boolean hasSeq(RosType type) {
        return isRos1 && type.name().equals("std_msgs/msg/Header");
    }

    ObjectNode toJson(RosMessage message) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        if (hasSeq(message.type())) {
            node.put("seq", 7);
        }
        for (Field field : message.type().fields()) {
            Object value = message.fields().get(field.name());
            node.set(
                    name(message.type(), field),
                    field.type().repeat() == Repeat.ONE
                            ? oneToJson(value)
                            : allToJson(field.type().element(), value));
        }
        return node;
    }

    private JsonNode oneToJson(Object value) {
        JsonNodeFactory nodes = JsonNodeFactory.instance;
        return switch (value) {
            case RosMessage nested -> toJson(nested);
            case String text -> nodes.stringNode(text);
            case Boolean truth -> nodes.booleanNode(truth);
            case Long number -> nodes.numberNode(number);
            case Double number -> Double.isFinite(number) ? nodes.numberNode(number) : nodes.nullNode();
            default -> throw new AssertionError(value);
        };
    }

    private JsonNode allToJson(Element element, Object value) {
        if (element == Primitive.UINT8) {
            return JsonNodeFactory.instance.stringNode(Base64.getEncoder().encodeToString((byte[]) value));
        }
        ArrayNode all = JsonNodeFactory.instance.arrayNode();
        if (value instanceof List<?> list) {
            list.forEach(each -> all.add(oneToJson(each)));
        } else {
            for (int i = 0; i < java.lang.reflect.Array.getLength(value); i++) {
                all.add(oneToJson(number(element, java.lang.reflect.Array.get(value, i))));
            }
        }
        return all;
    }

    /// An element of an array as a field of its own would have it.
    private static Object number(Element element, Object each) {
        if (element == Primitive.BOOL) {
            return ((Byte) each) != 0;
        }
        if (each instanceof Float || each instanceof Double) {
            return ((Number) each).doubleValue();
        }
        return ((Number) each).longValue();
    }

    /// @throws Refused for types that servers fail to write
    Map<String, Object> toCbor(RosMessage message) throws Refused {
        Map<String, Object> map = new LinkedHashMap<>();
        if (hasSeq(message.type())) {
            map.put("seq", 7);
        }
        for (Field field : message.type().fields()) {
            Object value = message.fields().get(field.name());
            map.put(name(message.type(), field), cbor(field, value));
        }
        return map;
    }

    private Object cbor(Field field, Object value) throws Refused {
        boolean isOne = field.type().repeat() == Repeat.ONE;
        boolean isMessage = field.type().element() instanceof Element.Nested;
        if (!isOne && field.type().repeat() != Repeat.ANY) {
            throw new Refused("'float' object has no attribute '__slots__'");
        }
        if (isOne) {
            return isMessage ? toCbor((RosMessage) value) : value;
        }
        if (isMessage) {
            var all = new ArrayList<Object>();
            for (Object each : (List<?>) value) {
                all.add(toCbor((RosMessage) each));
            }
            return all;
        }
        return switch (field.type().element()) {
            case Primitive primitive ->
                switch (primitive) {
                    case UINT8 -> value;
                    case BOOL -> {
                        var all = new ArrayList<Object>();
                        for (byte each : (byte[]) value) {
                            all.add(each != 0);
                        }
                        yield all;
                    }
                    case INT8, BYTE -> new CborWriter.Tagged(72, (byte[]) value);
                    case UINT16 -> new CborWriter.Tagged(69, CborWriter.little(value));
                    case UINT32 -> new CborWriter.Tagged(70, CborWriter.little(value));
                    case UINT64 -> new CborWriter.Tagged(71, CborWriter.little(value));
                    case INT16 -> new CborWriter.Tagged(77, CborWriter.little(value));
                    case INT32 -> new CborWriter.Tagged(78, CborWriter.little(value));
                    case INT64 -> new CborWriter.Tagged(79, CborWriter.little(value));
                    case FLOAT32 -> new CborWriter.Tagged(85, CborWriter.little(value));
                    case FLOAT64 -> new CborWriter.Tagged(86, CborWriter.little(value));
                };
            default -> throw new Refused("'str' object has no attribute '__slots__'");
        };
    }

    /// @param given what a client sends
    RosMessage ofJson(String typeName, JsonNode given) throws Refused {
        RosType type = types.get(typeName);
        RosMessage message = MessageCodec.of(type, types).zero();
        if (!given.isObject()) {
            throw new Refused("Expected a JSON object for type %s but received a %s".formatted(typeName, given));
        }
        for (Entry<String, JsonNode> entry : given.properties()) {
            Field field = type.fields().stream()
                    .filter(each -> name(type, each).equals(entry.getKey())
                            && !each.name().equals(NOTHING))
                    .findFirst()
                    .orElseThrow(() -> new Refused(
                            "Message type %s does not have a field %s".formatted(typeName, entry.getKey())));
            JsonNode value = entry.getValue();
            message = message.with(
                    field.name(),
                    field.type().repeat() == Repeat.ONE
                            ? one(field.type().element(), value)
                            : all(field.type().element(), value));
        }
        return message;
    }

    private Object one(Element element, JsonNode value) throws Refused {
        boolean isFitting = switch (element) {
            case Element.Nested _ -> value.isObject();
            case Element.Text _ -> value.isString();
            case Primitive primitive -> primitive == Primitive.BOOL ? value.isBoolean() : value.isNumber();
        };
        if (!isFitting) {
            throw new Refused("message requires a %s, but got a %s".formatted(element, value));
        }
        return switch (element) {
            case Element.Nested(String name) -> ofJson(name, value);
            case Element.Text _ -> value.asString();
            case Primitive primitive ->
                switch (primitive) {
                    case BOOL -> value.booleanValue();
                    case FLOAT32, FLOAT64 -> value.doubleValue();
                    default -> value.longValue();
                };
        };
    }

    private Object all(Element element, JsonNode value) throws Refused {
        if (element == Primitive.UINT8 && value.isString()) {
            return Base64.getDecoder().decode(value.asString());
        }
        if (!value.isArray()) {
            throw new Refused("message requires a list, but got a %s".formatted(value));
        }
        var all = new ArrayList<Object>();
        for (JsonNode each : value) {
            all.add(one(element, each));
        }
        return switch (element) {
            case Primitive primitive -> array(primitive, all);
            default -> all;
        };
    }

    private static Object array(Primitive primitive, List<Object> all) {
        Class<?> type = switch (primitive) {
            case BOOL, BYTE, INT8, UINT8 -> byte.class;
            case INT16, UINT16 -> short.class;
            case INT32, UINT32 -> int.class;
            case INT64, UINT64 -> long.class;
            case FLOAT32 -> float.class;
            case FLOAT64 -> double.class;
        };
        Object array = java.lang.reflect.Array.newInstance(type, all.size());
        for (int i = 0; i < all.size(); i++) {
            Object each = all.get(i);
            Number number = each instanceof Boolean truth ? Integer.valueOf(truth ? 1 : 0) : (Number) each;
            switch (array) {
                case byte[] bytes -> bytes[i] = number.byteValue();
                case short[] shorts -> shorts[i] = number.shortValue();
                case int[] ints -> ints[i] = number.intValue();
                case long[] longs -> longs[i] = number.longValue();
                case float[] floats -> floats[i] = number.floatValue();
                default -> ((double[]) array)[i] = number.doubleValue();
            }
        }
        return array;
    }
}
