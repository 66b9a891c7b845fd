package rsal.ros2.type;

import java.util.LinkedHashMap;
import java.util.Map;

/// Writes definitions as [DefinitionReader] reads them, without comments and constants.
public final class DefinitionWriter {
    private static final String NEXT = "=".repeat(80);

    private DefinitionWriter() {}

    /// A message with those within it, as schemas `ros2msg` of MCAP have them.
    ///
    /// @throws InvalidDefinition when the library lacks a type within
    public static String withDependencies(RosType type, TypeLibrary library) {
        var within = new LinkedHashMap<String, RosType>();
        collect(type, library, within);
        var text = new StringBuilder(fields(type));
        within.forEach((name, nested) ->
                text.append("%s\nMSG: %s\n%s".formatted(NEXT, name.replace("/msg/", "/"), fields(nested))));
        return text.toString();
    }

    private static void collect(RosType type, TypeLibrary library, Map<String, RosType> into) {
        for (Field field : type.fields()) {
            if (field.type().element() instanceof Element.Nested(String name) && !into.containsKey(name)) {
                RosType nested = library.get(name);
                into.put(name, nested);
                collect(nested, library, into);
            }
        }
    }

    /// The fields of a type, one in each line, without those within them.
    public static String fields(RosType type) {
        var text = new StringBuilder();
        for (Field field : type.fields()) {
            if (!field.equals(RosType.NOTHING)) {
                text.append("%s%s %s%s\n"
                        .formatted(
                                element(field.type().element()),
                                repeat(field.type()),
                                field.name(),
                                field.fallback().isEmpty() ? "" : " " + field.fallback()));
            }
        }
        return text.toString();
    }

    private static String element(Element element) {
        return switch (element) {
            case Primitive primitive -> primitive.text();
            case Element.Text(boolean isWide, int most) ->
                (isWide ? "wstring" : "string") + (most == 0 ? "" : "<=" + most);
            case Element.Nested(String name) -> name.replace("/msg/", "/");
        };
    }

    private static String repeat(FieldType type) {
        return switch (type.repeat()) {
            case ONE -> "";
            case ARRAY -> "[%d]".formatted(type.count());
            case BOUNDED -> "[<=%d]".formatted(type.count());
            case ANY -> "[]";
        };
    }
}
