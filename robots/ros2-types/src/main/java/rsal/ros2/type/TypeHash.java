package rsal.ros2.type;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

/// The hash of a type (REP 2016, *ROS Interface Hashing Standard version 1*): SHA-256 of its description in JSON, with
/// those of all types within. Without defaults, constants and comments.
public final class TypeHash {
    private static final String PREFIX = "RIHS01_";
    private static final int MOST_TYPES = 1_000; // that one is made of

    private TypeHash() {}

    /// `RIHS01_64c1…`
    ///
    /// @throws InvalidDefinition when the library lacks a type within
    public static String of(RosType type, TypeLibrary library) {
        String description = description(type, library);
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(description.getBytes(StandardCharsets.UTF_8));
            return PREFIX + HexFormat.of().formatHex(hash);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e); // each Java has it
        }
    }

    private static String description(RosType type, TypeLibrary library) {
        var within = new TreeMap<String, RosType>();
        collect(type, library, within);
        return "{\"type_description\": %s, \"referenced_type_descriptions\": [%s]}"
                .formatted(
                        json(type), within.values().stream().map(TypeHash::json).collect(Collectors.joining(", ")));
    }

    private static void collect(RosType type, TypeLibrary library, SortedMap<String, RosType> into) {
        for (Field field : type.fields()) {
            if (field.type().element() instanceof Element.Nested(String name) && !into.containsKey(name)) {
                RosType nested = library.get(name);
                into.put(name, nested);
                if (into.size() > MOST_TYPES) {
                    throw new InvalidDefinition(
                            "'%s' is made of more than %d types.".formatted(type.name(), MOST_TYPES));
                }
                collect(nested, library, into);
            }
        }
    }

    private static String json(RosType type) {
        return "{\"type_name\": \"%s\", \"fields\": [%s]}"
                .formatted(
                        type.name(), type.fields().stream().map(TypeHash::json).collect(Collectors.joining(", ")));
    }

    private static String json(Field field) {
        FieldType type = field.type();
        int most = type.element() instanceof Element.Text(boolean _, int bound) ? bound : 0;
        String nested = type.element() instanceof Element.Nested(String name) ? name : "";
        return "{\"name\": \"%s\", \"type\": {\"type_id\": %d, \"capacity\": %d, \"string_capacity\": %d, \"nested_type_name\": \"%s\"}}"
                .formatted(field.name(), id(type), type.count(), most, nested);
    }

    /// Numbers of `type_description_interfaces/msg/FieldType`.
    private static int id(FieldType type) {
        int element = switch (type.element()) {
            case Primitive primitive -> primitive.id();
            case Element.Text(boolean isWide, int most) -> (most == 0 ? 17 : 21) + (isWide ? 1 : 0);
            case Element.Nested _ -> 1;
        };
        return element
                + switch (type.repeat()) {
                    case ONE -> 0;
                    case ARRAY -> 48;
                    case BOUNDED -> 96;
                    case ANY -> 144;
                };
    }
}
