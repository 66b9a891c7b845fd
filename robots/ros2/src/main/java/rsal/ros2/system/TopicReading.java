package rsal.ros2.system;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.MessageJson;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.type.DefinitionFolder;
import rsal.ros2.type.DefinitionWriter;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.InvalidDefinition;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;
import rsal.settings.Suggestion;
import rsal.system.Diagnosis.Finding;

/// Reads the newest message of any topic, for people: with the definitions that come with RSAL, and those of a folder.
final class TopicReading {
    private static final String WHAT = "topic";

    private final RosLink link;
    private final List<RosType> own; // definitions

    /// @param own definitions, beside and before those of RSAL
    TopicReading(RosLink link, List<RosType> own) {
        this.link = link;
        this.own = List.copyOf(own);
    }

    /// Those of a folder; none where it is not named.
    ///
    /// @throws IllegalArgumentException when they can't be read; its message is a sentence
    static List<RosType> definitions(String folder) {
        try {
            return folder.isEmpty() ? List.of() : DefinitionFolder.read(Path.of(folder));
        } catch (InvalidDefinition e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /// Whether somebody publishes it.
    boolean isThere(String topic) {
        return !publishers(topic).isEmpty();
    }

    private List<RosEndpoint> publishers(String topic) {
        return link.endpoints().stream()
                .filter(each -> each.isPublisher() && each.topic().name().equals(topic))
                .toList();
    }

    /// @param topic with its namespace: `/r1/gas`
    /// @param patience how long to wait for a message
    List<Finding> look(String topic, Duration patience) throws InterruptedException {
        List<RosEndpoint> publishers = publishers(topic);
        if (publishers.isEmpty()) {
            var published = new TreeSet<String>();
            link.endpoints().stream()
                    .filter(RosEndpoint::isPublisher)
                    .forEach(each -> published.add(each.topic().name()));
            return List.of(new Finding(
                    WHAT, false, "nobody publishes '%s'".formatted(topic), Suggestion.among(topic, published)));
        }
        RosEndpoint first = publishers.getFirst();
        String type = first.topic().type();
        var findings = new ArrayList<Finding>();
        findings.add(new Finding(WHAT, true, "'%s' has messages of %s".formatted(topic, type), ""));
        try {
            findings.addAll(read(publishers, type, patience));
        } catch (InvalidDefinition e) {
            findings.add(new Finding(
                    "definition",
                    false,
                    String.valueOf(e.getMessage()),
                    "Read those of the robot: --set definitions=FOLDER, which has PACKAGE/msg/NAME.msg"));
        }
        return findings;
    }

    private List<Finding> read(List<RosEndpoint> publishers, String name, Duration patience)
            throws InterruptedException {
        RosEndpoint first = publishers.getFirst();
        TypeLibrary types = types(name, first.typeHash());
        RosType type = types.get(name);
        MessageCodec codec = MessageCodec.of(type, types);
        var findings = new ArrayList<Finding>();
        findings.add(new Finding("fields", true, DefinitionWriter.fields(type).strip(), ""));
        if (first.typeHash().isPresent() && !first.typeHash().equals(types.hash(name))) {
            findings.add(new Finding(
                    "definition",
                    false,
                    "the robot's definition of %s is another one than that here".formatted(name),
                    "Read those of the robot: --set definitions=FOLDER"));
        }
        findings.add(newest(publishers, patience)
                .map(bytes -> message(codec, bytes))
                .orElseGet(() -> new Finding(
                        "message",
                        false,
                        "none has come within %.1f s".formatted(patience.toMillis() / 1e3),
                        "Wait for longer: --set time=30")));
        return findings;
    }

    /// Those of the distribution that announces this hash; of Humble, whose programs announce none.
    private TypeLibrary types(String name, Optional<String> hash) {
        List<TypeLibrary> all = Arrays.stream(Distribution.values())
                .sorted(Comparator.comparing(each -> each != Distribution.JAZZY)) // where several fit
                .map(each -> TypeLibrary.of(each).with(own))
                .toList();
        return hash.isEmpty()
                ? TypeLibrary.of(Distribution.HUMBLE).with(own)
                : all.stream()
                        .filter(types -> types.hash(name).equals(hash))
                        .findFirst()
                        .orElse(all.getFirst());
    }

    private Optional<byte[]> newest(List<RosEndpoint> publishers, Duration patience) throws InterruptedException {
        var coming = new CompletableFuture<byte[]>();
        var profile = publishers.stream()
                .map(RosEndpoint::profile)
                .min(Comparator.naturalOrder())
                .orElseThrow(); // fits all of them
        try (var _ = link.subscribe(publishers.getFirst().topic(), profile, bytes -> coming.complete(copy(bytes)))) {
            return Optional.of(coming.get(patience.toMillis(), TimeUnit.MILLISECONDS));
        } catch (TimeoutException | ExecutionException e) {
            return Optional.empty();
        }
    }

    private static byte[] copy(ByteBuffer bytes) {
        var copy = new byte[bytes.remaining()];
        bytes.duplicate().get(copy);
        return copy;
    }

    private static Finding message(MessageCodec codec, byte[] bytes) {
        try {
            return new Finding("message", true, MessageJson.of(codec.read(CdrReader.of(bytes))), "");
        } catch (InvalidCdr e) {
            return new Finding(
                    "message",
                    false,
                    "a message of %d bytes does not fit: %s".formatted(bytes.length, e.getMessage()),
                    "Is its definition that of the robot? --set definitions=FOLDER");
        }
    }
}
