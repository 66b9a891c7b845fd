package rsal.ros2.bag;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.mcap.Channel;
import rsal.mcap.McapFile;
import rsal.mcap.Schema;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Parameter;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTree;
import rsal.ros2.message.ScanMessage;
import rsal.ros2.type.DefinitionReader;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.InvalidDefinition;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;

/// Reads the files of one bag: first where frames are on the robot, as what is said once may stand anywhere, then
/// scans and odometry. Topics are found by their types; of several of a type, the one with the most messages is
/// taken. Times are those of the messages' headers, not of their arrival.
final class BagReader {
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
    private final FrameTree frames = new FrameTree();
    private final Map<Schema, MessageCodec> codecs = new HashMap<>(); // of each file
    private final Map<String, Long> counts = new HashMap<>(); // of messages by topic, in all files
    private final Map<String, String> types = new HashMap<>(); // by topic
    private @Nullable String base;
    private int number; // of the message, from 1; 0 before scans are read

    BagReader(String name, LaserHints hints, LogCollector log) {
        this.name = name;
        this.hints = hints;
        this.log = log;
    }

    /// What does not move on the robot, which topics there are, and what the base is called.
    void readFrames(McapFile bag) throws IOException {
        for (Channel channel : bag.channels()) {
            counts.merge(channel.topic(), bag.count(channel), Long::sum);
            types.put(channel.topic(), type(bag, channel));
        }
        Optional<String> odometry = most(ODOMETRY);
        bag.read(
                channel -> isStatic(channel) || odometry.equals(Optional.of(channel.topic())),
                (channel, _, _, _, data) -> {
                    if (isStatic(channel)) {
                        message(bag, channel, data, false).ifPresent(frames::add);
                    } else if (base == null) { // the first names it
                        message(bag, channel, data, false)
                                .ifPresent(message -> base = FrameTree.named(message.text("child_frame_id")));
                    }
                });
    }

    private boolean isStatic(Channel channel) {
        return TRANSFORMS.equals(types.get(channel.topic())) && channel.topic().endsWith(STATIC);
    }

    /// Scans and odometry, in the order of their arrival.
    ///
    /// @throws BrokenLog when there are no scans
    void readScans(McapFile bag) throws IOException {
        String scans = most(SCAN)
                .orElseThrow(() -> new BrokenLog(
                        name,
                        0,
                        "There are no scans in it: no topic of the type '%s', but %s."
                                .formatted(SCAN, types.isEmpty() ? "nothing" : types)));
        Optional<String> odometry = most(ODOMETRY);
        bag.read(
                channel -> channel.topic().equals(scans)
                        || odometry.map(channel.topic()::equals)
                                .orElseGet(() -> TRANSFORMS.equals(types.get(channel.topic())) && !isStatic(channel)),
                (channel, _, _, _, data) -> {
                    number++;
                    boolean isScan = channel.topic().equals(scans);
                    RosMessage message = message(bag, channel, data, isScan).orElse(null);
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

    /// Says which topics were read.
    void end() throws BrokenLog {
        for (String type : List.of(SCAN, ODOMETRY)) {
            Optional<String> topic = most(type);
            if (topic.isPresent()) {
                log.add(new Parameter(number, type, topic.get()));
            }
        }
    }

    private Optional<String> most(String type) {
        return types.entrySet().stream()
                .filter(entry -> entry.getValue().equals(type))
                .map(Map.Entry::getKey)
                .max(Comparator.<String>comparingLong(topic -> counts.getOrDefault(topic, 0L))
                        .thenComparing(Comparator.reverseOrder()));
    }

    /// Skips what can't be read.
    private Optional<RosMessage> message(McapFile bag, Channel channel, ByteBuffer data, boolean isScan) {
        try {
            return Optional.of(codec(bag, channel).read(CdrReader.of(data)));
        } catch (InvalidCdr | InvalidDefinition e) {
            log.skip(number, "not readable", String.valueOf(e.getMessage()), isScan);
            return Optional.empty();
        }
    }

    private static String type(McapFile bag, Channel channel) {
        return bag.schema(channel).map(Schema::name).orElse("");
    }

    /// By the definition that the bag has; of bags without any, by that of ROS 2 Jazzy.
    private MessageCodec codec(McapFile bag, Channel channel) {
        return codecs.computeIfAbsent(bag.schema(channel).orElseThrow(), BagReader::codec);
    }

    private static MessageCodec codec(Schema schema) {
        TypeLibrary library = TypeLibrary.of(Distribution.JAZZY);
        String definition =
                schema.encoding().equals("ros2msg") ? new String(schema.data(), StandardCharsets.UTF_8) : "";
        if (definition.isBlank()) {
            return MessageCodec.of(library.get(schema.name()), library);
        }
        List<RosType> types = DefinitionReader.withDependencies(schema.name(), definition);
        return MessageCodec.of(types.getFirst(), library.with(types));
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
        for (RosMessage stamped : message.messages("transforms")) {
            String parent = FrameTree.named(stamped.message("header").text("frame_id"));
            String child = FrameTree.named(stamped.text("child_frame_id"));
            FrameTransform transform = FrameTransform.of(stamped.message("transform"), "translation", "rotation");
            if (isOdom(parent) && isBase(child) && transform.isFinite()) {
                base = child;
                log.add(new Motion(number, time(stamped), transform.planar(), 0, 0));
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
                    "a laser that can't be",
                    "Its first angle is '%s', the angle between readings '%s'."
                            .formatted(scan.angleMin(), scan.angleIncrement()),
                    true);
            return;
        }
        Optional<FrameTransform> mount = frames.find(base == null ? BASE_FRAME : base, scan.frame());
        int broken = scan.broken();
        LaserScan read = scan.scan(mount.orElse(FrameTransform.NONE), hints.rangeMax());
        log.add(new Scan(number, time(message), read, new Poses.Untold(), broken));
    }
}
