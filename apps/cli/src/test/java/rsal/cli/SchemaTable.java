package rsal.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// The keys of one group of a JSON Schema.
final class SchemaTable {
    private static final Path SCHEMAS = Path.of("../../docs/reference");
    private static final String ARGUMENT = "#/$defs/argument"; // may stand for any value

    private SchemaTable() {}

    /// @param reference `scenario.schema.json#/properties/communication`, which must have properties
    static String of(String reference) {
        String[] fileAndPointer = reference.split("#", 2);
        JsonNode group = read(fileAndPointer[0]).at(fileAndPointer[1]);
        if (!group.path("properties").isObject()) {
            throw new IllegalArgumentException("There is no group '%s'.".formatted(reference));
        }
        List<String> required =
                group.path("required").valueStream().map(JsonNode::asString).toList();
        var table = new Markdown.Table("key", "", "default", "");
        group.path("properties")
                .propertyStream()
                .forEach(property -> table.row(
                        Markdown.code(property.getKey()),
                        values(property.getValue()),
                        required.contains(property.getKey())
                                ? "required"
                                : property.getValue().has("default")
                                        ? Markdown.value(
                                                plain(property.getValue().get("default")))
                                        : "",
                        Markdown.text(property.getValue().path("description").asString(""))));
        return table.toString();
    }

    private static JsonNode read(String file) {
        try {
            return new JsonMapper().readTree(Files.readString(SCHEMAS.resolve(file)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// What can be written there, for people.
    private static String values(JsonNode schema) {
        return kinds(schema).distinct().collect(Collectors.joining(" or "));
    }

    private static Stream<String> kinds(JsonNode schema) {
        for (String choice : List.of("anyOf", "oneOf")) {
            if (schema.has(choice) && !schema.has("properties")) {
                return schema.get(choice)
                        .valueStream()
                        .filter(one -> !one.path("$ref").asString("").equals(ARGUMENT))
                        .flatMap(SchemaTable::kinds);
            }
        }
        if (schema.has("const")) {
            return Stream.of(Markdown.value(plain(schema.get("const"))));
        }
        if (schema.has("enum")) {
            return schema.get("enum").valueStream().map(word -> Markdown.value(plain(word)));
        }
        if (schema.has("$ref")) {
            return Stream.of("group");
        }
        return Stream.of(
                switch (schema.path("type").asString("")) {
                    case "integer" -> "whole number" + bounds(schema);
                    case "number" -> "number" + bounds(schema);
                    case "boolean" -> "`true` or `false`";
                    case "array" -> list(schema);
                    case "object" ->
                        schema.has("properties") || !schema.has("additionalProperties") ? "group" : "groups by name";
                    default -> "text";
                });
    }

    private static String list(JsonNode schema) {
        int least = schema.path("minItems").asInt(0);
        boolean fixed = least > 1 && schema.path("maxItems").asInt(0) > 0;
        boolean numbers = schema.path("items").toString().contains("\"number\"");
        return !fixed
                ? "list"
                : "%d%s%s"
                        .formatted(
                                least,
                                schema.path("maxItems").asInt() == least
                                        ? ""
                                        : " or " + schema.path("maxItems").asInt(),
                                numbers ? " numbers" : " values");
    }

    private static String bounds(JsonNode schema) {
        String least = schema.has("minimum") ? number(schema.get("minimum")) : "";
        String most = schema.has("maximum") ? number(schema.get("maximum")) : "";
        if (schema.has("exclusiveMinimum")) {
            return " over " + number(schema.get("exclusiveMinimum"));
        }
        if (least.isEmpty()) {
            return most.isEmpty() ? "" : ", at most " + most;
        }
        return most.isEmpty() ? ", at least " + least : ", %s to %s".formatted(least, most);
    }

    private static String number(JsonNode value) {
        return Markdown.value(value.asDouble()).replace("`", "");
    }

    private static Object plain(JsonNode value) {
        return value.isNumber()
                ? (Object) value.asDouble()
                : value.isString() ? value.asString() : value.toString().replace(",", ", ");
    }
}
