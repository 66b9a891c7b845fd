package rsal.recording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Field;
import rsal.recording.proto.MessageType.Kind;

/// A row is a message, or an element of its list. Columns are fields, those of messages within by their path
/// (`pose.position.x`). Numbers of which there are many are in one cell, with spaces between them, as are messages,
/// with colons between their fields. Bytes are left out. A device that saw nothing has a row, too, without an
/// element, as have links when there are none.
record FieldTable(MessageType type, String list) implements MessageTable {
    private static final Map<String, String> LISTS = Map.of(
            "rsal.State", "robots",
            "foxglove.FrameTransforms", "transforms",
            "rsal.Blobs", "blobs",
            "rsal.BumperState", "bumpers",
            "rsal.Fiducials", "fiducials",
            "rsal.Quantities", "quantities",
            "rsal.Links", "links");

    FieldTable(MessageType type) {
        this(type, LISTS.getOrDefault(type.name(), ""));
    }

    @Override
    public List<String> columns(Map<String, Object> first) {
        var columns = new ArrayList<String>();
        columns(type, "", list, columns);
        return columns;
    }

    @Override
    public List<Map<String, String>> rows(Map<String, Object> message) {
        var rows = new ArrayList<Map<String, String>>();
        for (Map<String, Object> element : elements(message)) {
            var cells = new HashMap<String, String>();
            cells(message, "", list, cells);
            cells(element, list + ".", "", cells);
            rows.add(cells);
        }
        return rows;
    }

    private List<Map<String, Object>> elements(Map<String, Object> message) {
        List<?> all = message.get(list) instanceof List<?> many ? many : List.of();
        boolean isOne = list.isEmpty()
                || (all.isEmpty()
                        && (type.equals(Own.LINKS)
                                || ReadingType.named(type.name()).isPresent()));
        return isOne ? List.of(Map.of()) : all.stream().map(FieldTable::fields).toList();
    }

    private static void columns(MessageType type, String path, String list, List<String> columns) {
        for (Field field : type.fields()) {
            String name = path + field.name();
            boolean isWithin = field.kind() == Kind.MESSAGE && (!field.repeated() || name.equals(list));
            if (isWithin && field.type().get().name().startsWith("google.protobuf.")) {
                columns.add(name);
            } else if (isWithin) {
                columns(field.type().get(), name + ".", "", columns);
            } else if (field.kind() != Kind.BYTES) {
                columns.add(name);
            }
        }
    }

    private static void cells(Map<String, Object> message, String path, String list, Map<String, String> cells) {
        message.forEach((key, value) -> {
            String name = path + key;
            switch (value) {
                case Map<?, ?> within
                when within.containsKey("seconds") && within.containsKey("nanos") -> cells.put(name, timestamp(within));
                case Map<?, ?> within -> cells(fields(within), name + ".", "", cells);
                case List<?> many when name.equals(list) -> {} // rows of their own
                case List<?> many ->
                    cells.put(name, many.stream().map(FieldTable::cell).collect(Collectors.joining(" ")));
                case byte[] _ -> {} // left out
                default -> cells.put(name, value.toString());
            }
        });
    }

    /// Of a list: pairs as `key=value`.
    private static String cell(Object value) {
        if (!(value instanceof Map<?, ?> map)) {
            return value.toString();
        }
        return map.containsKey("key")
                ? map.get("key") + "=" + map.get("value")
                : map.values().stream().map(FieldTable::cell).collect(Collectors.joining(":"));
    }

    private static Map<String, Object> fields(Object message) {
        var fields = new LinkedHashMap<String, Object>();
        if (message instanceof Map<?, ?> map) {
            map.forEach((key, value) -> fields.put(String.valueOf(key), value));
        }
        return fields;
    }

    private static String timestamp(Map<?, ?> time) {
        return time.get("seconds") instanceof Long seconds && time.get("nanos") instanceof Long nanos
                ? Double.toString((seconds * 1_000_000_000L + nanos) / 1e9)
                : "";
    }
}
