package rsal.recording;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.map.RosMap;
import rsal.mcap.Channel;
import rsal.mcap.McapFile;
import rsal.mcap.Schema;
import rsal.recording.proto.Descriptors;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.ProtoReader;
import rsal.scenario.text.CsvLine;

/// Writes messages as tables, one for each topic: a row is a message, or, where a message is a list (robots of
/// a state, transforms, particles, points of a path), an element of it. The first column is the log time in
/// seconds, the others are fields ([MessageTable]). Of maps the tables tell when they were drawn; the last of
/// each lies beside its table as ROS has maps ([RosMap]). Things, the world and bodies are left out. For one
/// thread.
public final class CsvExport {
    private static final Map<String, MessageType> KNOWN = Stream.concat(
                    ReadingType.ALL.stream().map(ReadingType::message),
                    Stream.of(
                            Foxglove.FRAME_TRANSFORMS,
                            Foxglove.POSE_IN_FRAME,
                            Foxglove.POINT_CLOUD,
                            Foxglove.SCENE_UPDATE,
                            Foxglove.LOG,
                            Own.STATE,
                            Own.ROBOT,
                            Own.DEVICE,
                            Own.EVENT,
                            Own.MESSAGE,
                            Own.AGENT,
                            Own.MIND,
                            Own.LINKS))
            .collect(Collectors.toUnmodifiableMap(MessageType::name, type -> type));

    private static final String TABLE = ".csv";
    private static final String IMAGE = ".pgm";
    private static final String MAP = ".yaml";

    private final McapFile file;
    private final Map<Channel, MessageType> types = new LinkedHashMap<>();

    public CsvExport(McapFile file) {
        this.file = file;
        for (Channel channel : file.channels()) {
            Optional<MessageType> type = file.schema(channel).flatMap(CsvExport::type);
            type.filter(known -> !known.equals(Foxglove.SCENE_UPDATE)
                            || channel.topic().endsWith("/" + ChannelNames.PATH)
                            || channel.topic().endsWith("/" + ChannelNames.LOCAL_PATH))
                    .ifPresent(known -> types.put(channel, known));
        }
    }

    private static Optional<MessageType> type(Schema schema) {
        if (!schema.name().startsWith(ContentWriter.PACKAGE)) {
            return Optional.ofNullable(KNOWN.get(schema.name()));
        }
        try {
            return Descriptors.read(schema.data(), schema.name());
        } catch (IOException _) {
            return Optional.empty(); // another program's, which is called like ours
        }
    }

    /// Topics that have a table, in the order of the file.
    public List<String> topics() {
        return types.keySet().stream().map(Channel::topic).distinct().toList();
    }

    /// Leaves out all topics but these.
    public void keep(Collection<String> topics) {
        types.keySet().removeIf(channel -> !topics.contains(channel.topic()));
    }

    /// Names of the files.
    public List<String> names() {
        return types.entrySet().stream()
                .flatMap(entry -> endings(entry.getValue()).map(ending -> name(entry.getKey()) + ending))
                .toList();
    }

    private static Stream<String> endings(MessageType type) {
        return isMap(type) ? Stream.of(TABLE, IMAGE, MAP) : Stream.of(TABLE);
    }

    private static boolean isMap(MessageType type) {
        return type.equals(Foxglove.GRID);
    }

    /// Without the ending.
    private static String name(Channel channel) {
        String topic = channel.topic().startsWith("/") ? channel.topic().substring(1) : channel.topic();
        return topic.replaceAll("[^A-Za-z0-9_-]", ".");
    }

    /// Writes them all, one after the other; the folder is made if need be, and files that are there are lost.
    ///
    /// @return those that were written
    /// @throws IOException when one can't be written; at the end, when a map is none
    public List<Path> write(Path folder) throws IOException {
        Files.createDirectories(folder);
        var written = new ArrayList<Path>();
        var broken = new ArrayList<String>();
        for (var channel : types.entrySet()) {
            String name = name(channel.getKey());
            Path path = folder.resolve(name + TABLE);
            Optional<Map<String, Object>> last;
            try (Writer out = Files.newBufferedWriter(path)) {
                last = write(channel.getKey(), channel.getValue(), out);
            }
            written.add(path);
            if (isMap(channel.getValue()) && last.isPresent()) {
                try {
                    written.addAll(writeMap(Decoder.grid(new MessageFields(last.get())), folder, name));
                } catch (IllegalArgumentException e) { // of another program's recording
                    broken.add("The last map of '%s' can't be read: %s".formatted(name, e.getMessage()));
                }
            }
        }
        if (!broken.isEmpty()) {
            throw new IOException(String.join(" ", broken) + " All else is written.");
        }
        return written;
    }

    private static List<Path> writeMap(OccupancyGrid map, Path folder, String name) throws IOException {
        Path image = folder.resolve(name + IMAGE);
        Path yaml = folder.resolve(name + MAP);
        Files.write(image, RosMap.pgm(map));
        Files.writeString(yaml, RosMap.yaml(map, name + IMAGE));
        return List.of(image, yaml);
    }

    /// @return the last message
    private Optional<Map<String, Object>> write(Channel channel, MessageType type, Writer out) throws IOException {
        MessageTable table = MessageTable.of(type);
        var columns = new ArrayList<String>(); // once there is a message
        var last = new AtomicReference<@Nullable Map<String, Object>>();
        file.read(channel::equals, (_, _, logTime, _, data) -> {
            Map<String, Object> message = ProtoReader.read(type, data);
            last.set(message);
            if (columns.isEmpty()) {
                columns.addAll(table.columns(message));
                out.write(header(columns));
            }
            for (Map<String, String> row : table.rows(message)) {
                Stream<String> cells = columns.stream().map(column -> row.getOrDefault(column, ""));
                out.write(CsvLine.of(Stream.concat(Stream.of(Double.toString(logTime / 1e9)), cells)));
            }
        });
        if (columns.isEmpty()) {
            out.write(header(table.columns(Map.of())));
        }
        return Optional.ofNullable(last.get());
    }

    private static String header(Collection<String> columns) {
        return CsvLine.of(Stream.concat(Stream.of("log_time_s"), columns.stream()));
    }
}
