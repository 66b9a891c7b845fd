package rsal.ros2.record;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.mcap.McapWriter;
import rsal.mcap.Metadata;
import rsal.ros2.record.BagMetadata.Topic;
import rsal.ros2.type.DefinitionWriter;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeHash;
import rsal.ros2.type.TypeLibrary;

/// Writes a bag as rosbag2 of Jazzy does: a folder with `metadata.yaml` and one file in MCAP, or that file alone. All
/// types are those of Jazzy. Equal messages make equal bytes.
///
/// Whatever ends the process, messages that were written stay in the file, up to the chunk that is open (1 MB or one
/// second), and the folder has a `metadata.yaml`, which counts none of them until the end. For one thread.
public final class BagWriter implements Closeable {
    private static final String SUFFIX = ".mcap";
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final Optional<Path> folder;
    private final String name; // of the file
    private final McapWriter file;
    private final Map<String, Integer> schemas = new HashMap<>(); // by type
    private final List<Topic> topics = new ArrayList<>(); // without their counts
    private final List<Long> counts = new ArrayList<>(); // the same
    private long first = Long.MAX_VALUE; // times [ns]
    private long last = Long.MIN_VALUE;
    private boolean closed;

    private BagWriter(Optional<Path> folder, String name, McapWriter file) {
        this.folder = folder;
        this.name = name;
        this.file = file;
    }

    /// Begins a bag of one file in MCAP.
    ///
    /// @param force whether a file that is there may be lost
    /// @param program that writes, for people
    /// @param clock by which chunks grow old [ns]
    /// @throws FileAlreadyExistsException when it is there and may not
    public static BagWriter file(Path file, boolean force, String program, LongSupplier clock) throws IOException {
        return new BagWriter(Optional.empty(), String.valueOf(file.getFileName()), open(file, force, program, clock));
    }

    /// Begins a bag that is a folder.
    ///
    /// @param force whether a bag that is there may be lost; other files stay
    /// @param program that writes, for people
    /// @param clock by which chunks grow old [ns]
    /// @throws FileAlreadyExistsException when the folder has something, and may not lose it
    public static BagWriter folder(Path folder, boolean force, String program, LongSupplier clock) throws IOException {
        prepare(folder, force);
        String file = folder.getFileName() + "_0" + SUFFIX;
        var writer = new BagWriter(Optional.of(folder), file, open(folder.resolve(file), force, program, clock));
        try {
            writer.writeMetadata();
            return writer;
        } catch (IOException | RuntimeException e) {
            writer.close();
            throw e;
        }
    }

    private static McapWriter open(Path file, boolean force, String program, LongSupplier clock) throws IOException {
        FileChannel channel = FileChannel.open(
                file,
                force
                        ? Set.of(
                                StandardOpenOption.WRITE,
                                StandardOpenOption.CREATE,
                                StandardOpenOption.TRUNCATE_EXISTING)
                        : Set.of(StandardOpenOption.WRITE, StandardOpenOption.CREATE_NEW));
        try {
            return new McapWriter(channel, "ros2", program, clock);
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    /// Makes the folder, without the files of a bag that was in it.
    private static void prepare(Path folder, boolean force) throws IOException {
        if (!Files.isDirectory(folder)) {
            Files.createDirectory(folder);
            return;
        }
        List<Path> inside;
        try (Stream<Path> files = Files.list(folder)) {
            inside = files.toList();
        }
        if (!inside.isEmpty() && !force) {
            throw new FileAlreadyExistsException(folder.toString());
        }
        if (!inside.isEmpty()) {
            delete(folder);
        }
    }

    /// Deletes the bag in a folder: what its `metadata.yaml` names, and that file.
    ///
    /// @throws FileAlreadyExistsException when there is no bag, so that nothing else gets lost
    private static void delete(Path folder) throws IOException {
        Path metadata = folder.resolve(BagMetadata.NAME);
        List<String> files = BagMetadata.files(metadata)
                .orElseThrow(() -> new FileAlreadyExistsException(folder.toString(), null, "it is not a bag"));
        for (String file : files) {
            Files.deleteIfExists(folder.resolve(file));
        }
        Files.delete(metadata);
    }

    /// A new topic.
    ///
    /// @param topic with its namespace: `/robot1/scan`
    /// @param type in full: `sensor_msgs/msg/LaserScan`
    /// @return its number, for [#message]
    /// @throws rsal.ros2.type.InvalidDefinition when there is no such type
    public int topic(String topic, String type, OfferedQuality quality) throws IOException {
        RosType defined = TYPES.get(type);
        Integer schema = schemas.get(type);
        if (schema == null) {
            byte[] text = DefinitionWriter.withDependencies(defined, TYPES).getBytes(StandardCharsets.UTF_8);
            schema = file.schema(type, "ros2msg", text);
            schemas.put(type, schema);
        }
        String hash = TypeHash.of(defined, TYPES);
        topics.add(new Topic(topic, type, hash, quality, 0));
        counts.add(0L);
        var about = new TreeMap<>(Map.of("offered_qos_profiles", quality.yaml(0), "topic_type_hash", hash));
        return file.channel(schema, topic, "cdr", about);
    }

    /// @param topic as [#topic] returned it
    /// @param time when the message came [ns]
    /// @param data in CDR, with its encapsulation header
    public void message(int topic, long time, byte[] data) throws IOException {
        file.message(topic, time, time, ByteBuffer.wrap(data));
        counts.set(topic - 1, counts.get(topic - 1) + 1);
        first = Math.min(first, time);
        last = Math.max(last, time);
        file.tick();
    }

    /// How much of the file there is [B], without what is not yet written.
    public long size() {
        return file.size();
    }

    private BagMetadata metadata() {
        boolean isEmpty = first > last;
        return new BagMetadata(
                name,
                isEmpty ? 0 : first,
                isEmpty ? 0 : last - first,
                counts.stream().mapToLong(Long::longValue).sum(),
                IntStream.range(0, topics.size())
                        .mapToObj(i -> {
                            Topic topic = topics.get(i);
                            return new Topic(topic.name(), topic.type(), topic.hash(), topic.quality(), counts.get(i));
                        })
                        .toList());
    }

    private void writeMetadata() throws IOException {
        if (folder.isPresent()) {
            Files.writeString(folder.get().resolve(BagMetadata.NAME), metadata().yaml());
        }
    }

    /// Writes what is left, the index and the counts. Closing twice does nothing.
    @Override
    public void close() throws IOException {
        if (closed) {
            return;
        }
        closed = true;
        try (file) {
            file.metadata(new Metadata(
                    "rosbag2", Map.of("serialized_metadata", metadata().yaml())));
        }
        writeMetadata();
    }
}
