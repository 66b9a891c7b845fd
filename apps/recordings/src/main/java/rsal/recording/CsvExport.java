package rsal.recording;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.recording.mcap.Channel;
import rsal.recording.mcap.McapFile;
import rsal.recording.mcap.Schema;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Field;
import rsal.recording.proto.MessageType.Kind;
import rsal.recording.proto.ProtoReader;

/// Writes messages as tables, one for each topic: a row is a message, or, where a message is a list (robots of a state,
/// transforms), an element of it. The first column is the log time in seconds, the others are fields, those of messages
/// within by their path (`pose.position.x`). Numbers of which there are many are in one cell, with spaces between them.
/// Bytes (cells of maps, particles) and bodies are left out. For one thread.
public final class CsvExport {
    private static final Map<String, MessageType> KNOWN = Stream.of(
                    Foxglove.FRAME_TRANSFORMS,
                    Foxglove.POSE_IN_FRAME,
                    Foxglove.LASER_SCAN,
                    Foxglove.GRID,
                    Foxglove.POINT_CLOUD,
                    Foxglove.LOG,
                    Own.STATE,
                    Own.ROBOT,
                    Own.DEVICE,
                    Own.RANGES,
                    Own.EVENT,
                    Own.MESSAGE,
                    Own.AGENT,
                    Own.MIND)
            .collect(Collectors.toUnmodifiableMap(MessageType::name, type -> type));
    private static final Map<String, String> LISTS =
            Map.of("rsal.State", "robots", "foxglove.FrameTransforms", "transforms");

    private final McapFile file;
    private final Map<Channel, MessageType> types = new LinkedHashMap<>();

    public CsvExport(McapFile file) {
        this.file = file;
        for (Channel channel : file.channels()) {
            Optional<MessageType> type = file.schema(channel).map(Schema::name).map(KNOWN::get);
            type.ifPresent(known -> types.put(channel, known));
        }
    }

    /// Names of the files.
    public List<String> names() {
        return types.keySet().stream().map(CsvExport::name).toList();
    }

    private static String name(Channel channel) {
        String topic = channel.topic().startsWith("/") ? channel.topic().substring(1) : channel.topic();
        return topic.replaceAll("[^A-Za-z0-9_-]", ".") + ".csv";
    }

    /// Writes them all, one after the other; the folder is made if need be, and files that are there are lost.
    ///
    /// @return those that were written
    public List<Path> write(Path folder) throws IOException {
        Files.createDirectories(folder);
        var written = new ArrayList<Path>();
        for (var channel : types.entrySet()) {
            Path path = folder.resolve(name(channel.getKey()));
            try (Writer out = Files.newBufferedWriter(path)) {
                write(channel.getKey(), channel.getValue(), out);
            }
            written.add(path);
        }
        return written;
    }

    private void write(Channel channel, MessageType type, Writer out) throws IOException {
        String list = LISTS.getOrDefault(type.name(), "");
        var columns = new ArrayList<String>();
        columns(type, "", list, columns);
        out.write("log_time_s," + String.join(",", columns) + "\n");
        file.read(channel::equals, (_, _, logTime, _, data) -> {
            Map<String, Object> message = ProtoReader.read(type, data);
            for (Map<String, Object> element : elements(message, list)) {
                var cells = new HashMap<String, String>();
                cells(message, "", list, cells);
                cells(element, list + ".", "", cells);
                out.write(Double.toString(logTime / 1e9));
                for (String column : columns) {
                    out.write("," + quoted(cells.getOrDefault(column, "")));
                }
                out.write("\n");
            }
        });
    }

    private static List<Map<String, Object>> elements(Map<String, Object> message, String list) {
        if (list.isEmpty()) {
            return List.of(Map.of());
        }
        return message.get(list) instanceof List<?> all
                ? all.stream().map(CsvExport::fields).toList()
                : List.of();
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
                    cells.put(name, many.stream().map(CsvExport::cell).collect(Collectors.joining(" ")));
                case byte[] _ -> {} // left out
                default -> cells.put(name, value.toString());
            }
        });
    }

    /// Of a list: pairs as `key=value`.
    private static String cell(Object value) {
        return value instanceof Map<?, ?> pair && pair.containsKey("key")
                ? pair.get("key") + "=" + pair.get("value")
                : value.toString();
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

    /// As RFC 4180 has it.
    private static String quoted(String cell) {
        return cell.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r')
                ? "\"" + cell.replace("\"", "\"\"") + "\""
                : cell;
    }
}
