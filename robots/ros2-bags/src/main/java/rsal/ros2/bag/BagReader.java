package rsal.ros2.bag;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Parameter;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;
import rsal.ros2.bag.BagFile.Topic;
import rsal.ros2.bag.ZstdData.DamagedMessage;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.ScanMessage;
import rsal.ros2.tf.StampedTransform;
import rsal.ros2.tf.TransformBuffer;
import rsal.ros2.type.DefinitionReader;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.InvalidDefinition;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;

/// Reads the files of one bag: first where frames are on the robot, as what is said once may stand anywhere, then
/// scans and odometry. Topics are found by their types; of several with scans, the one that was asked for, or the
/// one with the most messages, is taken, and odometry and static frames are those of the same robot, by their
/// namespaces. Times are those of the messages'
/// headers, not of their arrival.
final class BagReader {
    private static final int MOST_TYPES = 8; // named in an error
    private static final int MOST_TOPICS = 20; // the same
    private static final String SCAN = "sensor_msgs/msg/LaserScan";
    private static final String ODOMETRY = "nav_msgs/msg/Odometry";
    private static final String TRANSFORMS = "tf2_msgs/msg/TFMessage";
    private static final String STATIC = "tf_static";
    private static final String ODOM_FRAME = "odom"; // REP 105
    private static final String BASE_FRAME = "base_link"; // where no odometry names another
    private static final List<String> BASES = List.of("base_footprint", BASE_FRAME);

    private final String name;
    private final LaserHints hints;
    private final LogCollector log;
    private final TransformBuffer frames = new TransformBuffer(TransformBuffer.HISTORY);
    private final Map<Topic, MessageCodec> codecs = new HashMap<>();
    private final Map<String, Long> counts = new HashMap<>(); // of messages by topic, in all files
    private final Map<String, String> types = new HashMap<>(); // by topic
    private final Comparator<String> byMessages = Comparator.<String>comparingLong(
                    topic -> counts.getOrDefault(topic, 0L))
            .thenComparing(Comparator.reverseOrder());
    private @Nullable String base;
    private int number; // of the message, from 1; 0 before scans are read

    BagReader(String name, LaserHints hints, LogCollector log) {
        this.name = name;
        this.hints = hints;
        this.log = log;
    }

    /// What does not move on the robot, which topics there are, and what the base is called.
    void readFrames(BagFile bag) throws IOException {
        for (Topic topic : bag.topics()) {
            counts.merge(topic.name(), bag.count(topic), Long::sum);
            types.put(topic.name(), topic.type());
        }
        Optional<String> odometry = odometry();
        bag.read(topic -> isOfRobot(topic) || odometry.equals(Optional.of(topic.name())), (topic, data) -> {
            if (isStatic(topic)) { // of this robot
                message(topic, data, false)
                        .ifPresent(message -> StampedTransform.of(message).forEach(frames::addFixed));
            } else if (base == null) { // the first names it
                message(topic, data, false)
                        .ifPresent(message -> base = RosMessages.frame(message.text("child_frame_id")));
            }
        });
    }

    private boolean isStatic(Topic topic) {
        return topic.type().equals(TRANSFORMS) && topic.name().endsWith(STATIC);
    }

    /// Scans and odometry, in the order of their arrival.
    ///
    /// @throws BrokenLog when there are no scans
    void readScans(BagFile bag) throws IOException {
        String scans = scans().orElseThrow(() -> new BrokenLog(name, 0, withoutScans()));
        Optional<String> odometry = odometry();
        bag.read(
                topic -> topic.name().equals(scans)
                        || odometry.map(topic.name()::equals)
                                .orElseGet(() -> topic.type().equals(TRANSFORMS) && !isStatic(topic)),
                (topic, data) -> {
                    number++;
                    boolean isScan = topic.name().equals(scans);
                    RosMessage message = message(topic, data, isScan).orElse(null);
                    if (message == null) {
                        return;
                    }
                    if (isScan) {
                        addScan(message);
                    } else if (odometry.isPresent()) {
                        addOdometry(message);
                    } else {
                        addTransforms(message);
                    }
                });
        bag.damage().forEach(damage -> log.skip(number, "damaged", damage, false));
    }

    private String withoutScans() {
        List<String> topics = topics(SCAN).sorted().toList();
        return topics.isEmpty()
                ? "There are no scans in it, of the type '%s'. %s".formatted(SCAN, words())
                : "It has no scans of topic '%s'. Topics of scans are: %s."
                        .formatted(hints.topic().orElse(""), some(topics));
    }

    private static String some(List<String> topics) {
        String first = topics.stream().limit(MOST_TOPICS).collect(Collectors.joining(", "));
        return topics.size() > MOST_TOPICS ? "%s and %d more".formatted(first, topics.size() - MOST_TOPICS) : first;
    }

    /// For people: what is in it instead of scans.
    private String words() {
        if (types.values().stream().anyMatch(type -> type.startsWith("rsal."))) {
            return "This is a recording of RSAL, not a bag of ROS 2.";
        }
        String some =
                types.values().stream().distinct().sorted().limit(MOST_TYPES).collect(Collectors.joining(", "));
        return some.isEmpty() ? "It is empty." : "It has %s.".formatted(some);
    }

    /// Says which topics were read.
    void end() throws BrokenLog {
        visit(SCAN, scans());
        scans().ifPresent(chosen -> log.scansAreOf(
                chosen,
                topics(SCAN).filter(topic -> !topic.equals(chosen)).sorted().toList()));
        visit(ODOMETRY, odometry());
    }

    private void visit(String type, Optional<String> topic) throws BrokenLog {
        if (topic.isPresent()) {
            log.add(new Parameter(number, type, topic.get()));
        }
    }

    private Stream<String> topics(String type) {
        return types.entrySet().stream()
                .filter(entry -> entry.getValue().equals(type))
                .map(Map.Entry::getKey);
    }

    private Optional<String> most(String type) {
        return topics(type).max(byMessages);
    }

    /// The topic of scans that is read: the one that was asked for, else the one with the most messages.
    private Optional<String> scans() {
        return hints.topic().isEmpty()
                ? most(SCAN)
                : topics(SCAN)
                        .filter(topic -> topic.equals(hints.topic().get())
                                || topic.equals("/" + hints.topic().get()))
                        .findFirst();
    }

    /// That of the robot whose scans are read, as far as names tell.
    private Optional<String> odometry() {
        return topics(ODOMETRY)
                .max(Comparator.<String>comparingInt(topic -> sharedLevels(topic, scans().orElse("")))
                        .thenComparing(byMessages));
    }

    /// How many names two topics have in common from the front: 1 of `/r1/front/scan` and `/r1/odom`.
    private static int sharedLevels(String topic, String other) {
        String[] names = topic.split("/", -1);
        String[] others = other.split("/", -1);
        int shared = 0;
        while (shared < Math.min(names.length, others.length) && names[shared].equals(others[shared])) {
            shared++;
        }
        return shared;
    }

    /// Whether a topic has static frames of all robots, or of the robot whose scans are read. If none has, all such
    /// topics count.
    private boolean isOfRobot(Topic topic) {
        return isStatic(topic)
                && (isAbove(topic.name())
                        || topics(TRANSFORMS)
                                .filter(name -> name.endsWith(STATIC))
                                .noneMatch(this::isAbove));
    }

    private boolean isAbove(String topic) {
        return scans().orElse("").startsWith(topic.substring(0, topic.lastIndexOf('/') + 1));
    }

    /// Skips what can't be read.
    private Optional<RosMessage> message(Topic topic, ByteBuffer data, boolean isScan) {
        try {
            MessageCodec codec = codecs.computeIfAbsent(topic, BagReader::codec);
            return Optional.of(codec.read(CdrReader.of(ZstdData.message(data))));
        } catch (InvalidCdr | InvalidDefinition | DamagedMessage e) {
            log.skip(number, "not readable", String.valueOf(e.getMessage()), isScan);
            return Optional.empty();
        }
    }

    /// By the definition that the bag has; of bags without any, by that of ROS 2 Jazzy.
    private static MessageCodec codec(Topic topic) {
        TypeLibrary library = TypeLibrary.of(Distribution.JAZZY);
        if (topic.definition().isBlank()) {
            return MessageCodec.of(library.get(topic.type()), library);
        }
        List<RosType> types = DefinitionReader.withDependencies(topic.type(), topic.definition());
        TypeLibrary its = library.with(types);
        if (!its.isLike(topic.type(), library)) {
            throw new InvalidDefinition(
                    "The bag defines '%s' without fields that it must have.".formatted(topic.type()));
        }
        return MessageCodec.of(types.getFirst(), its);
    }

    private static Instant time(RosMessage message) {
        RosMessage stamp = message.message("header").message("stamp");
        return Instant.ofEpochSecond(stamp.integer("sec"), stamp.integer("nanosec"));
    }

    private void addOdometry(RosMessage message) throws BrokenLog {
        FrameTransform odomFromBase =
                FrameTransform.of(message.message("pose").message("pose"), "position", "orientation");
        RosMessage twist = message.message("twist").message("twist");
        double speed = twist.message("linear").number("x");
        double turnRate = twist.message("angular").number("z");
        if (odomFromBase.isFinite() && Double.isFinite(speed + turnRate)) {
            log.add(new Motion(number, time(message), odomFromBase.planar(), speed, turnRate));
        } else {
            log.skip(number, "no numbers", "The odometry has values that are no numbers.", false);
        }
    }

    /// Odometry as TF has it, without velocities.
    private void addTransforms(RosMessage message) throws BrokenLog {
        for (StampedTransform stamped : StampedTransform.of(message)) {
            if (isOdom(stamped.parent()) && isBase(stamped.child())) {
                base = stamped.child();
                Instant time = Instant.ofEpochSecond(0, stamped.stamp());
                log.add(new Motion(number, time, stamped.parentFromChild().planar(), 0, 0));
            }
        }
    }

    private static boolean isOdom(String frame) {
        return frame.equals(ODOM_FRAME) || frame.endsWith("/" + ODOM_FRAME);
    }

    private static boolean isBase(String frame) {
        return BASES.contains(frame.substring(frame.lastIndexOf('/') + 1));
    }

    private void addScan(RosMessage message) throws BrokenLog {
        ScanMessage scan = ScanMessage.of(message);
        if (!scan.isPossible()) {
            log.skip(
                    number,
                    "an impossible laser",
                    "Its first angle is '%s', the angle between readings '%s'."
                            .formatted(scan.angleMin(), scan.angleIncrement()),
                    true);
            return;
        }
        Optional<FrameTransform> mount = frames.find(base == null ? BASE_FRAME : base, scan.frame(), scan.stamp())
                .transform();
        int broken = scan.broken();
        LaserScan read = scan.scan(mount.orElse(FrameTransform.NONE), hints.rangeMax());
        log.add(new Scan(number, time(message), read, new Poses.Unknown(), broken));
    }
}
