package rsal.recording;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Pattern;
import rsal.agent.Directory;
import rsal.agent.bdi.Mind;
import rsal.agent.platform.AgentPlatform;
import rsal.data.GripperState;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Prism;
import rsal.data.RangeArray;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.SimulationControl.Carried;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.DeviceView;
import rsal.engine.report.Link;
import rsal.engine.report.Reading;
import rsal.engine.report.RobotView;
import rsal.engine.report.Snapshot;
import rsal.engine.report.Teammate;
import rsal.model.RobotColors;
import rsal.model.RobotModels;
import rsal.recording.NewestRecords.Raw;
import rsal.recording.NewestRecords.Speech;
import rsal.recording.proto.MessageType;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.scene.Entity;

/// Makes snapshots of what [Encoder] wrote. What is none of its kind is left out: a file may be from anywhere. For one
/// thread.
///
/// Longer than 500 lines, since it is a list: a method for each topic of a recording.
final class Decoder {
    private static final Pattern UNFIT = Pattern.compile("[/\\\\\"\\p{Cntrl}]");
    private static final long SECOND = 1_000_000_000;

    private final List<Teammate> planned;
    private final Instant start;
    private IdentityHashMap<Raw, Optional<Object>> before =
            new IdentityHashMap<>(); // what the last snapshot was made of
    private IdentityHashMap<Raw, Optional<Object>> now = new IdentityHashMap<>();
    private final Map<String, ReadingType<?>> types; // of what devices tell, by topic

    /// A device.
    ///
    /// @param topic where what it tells was recorded; empty where that is not known, as in older recordings
    private record Recorded(DeviceView view, String topic) {}

    /// What devices of a robot told last: what is drawn of it, and all of it.
    private record Reported(
            Optional<Stamped<Odometry>> odometry,
            Optional<Stamped<PoseEstimate>> estimate,
            Optional<Stamped<LaserScan>> scan,
            Optional<Stamped<RangeArray>> ranges,
            Optional<Stamped<OccupancyGrid>> map,
            List<Reading> readings) {}

    private interface Reader<T> {
        T read(MessageFields fields, Instant time);
    }

    /// @param start of the run, on its own clock
    Decoder(RunPlan plan, Instant start) {
        this.start = start;
        this.planned =
                plan.robots().stream().map(robot -> mate(plan, robot.spec())).toList();
        this.types = new HashMap<>();
    }

    private Decoder(Decoder other) {
        this.start = other.start;
        this.planned = other.planned;
        this.types = other.types;
    }

    /// One that knows as much, now and later, and has made no snapshot yet: each makes what is new since its last.
    Decoder another() {
        return new Decoder(this);
    }

    /// A robot as it is planned.
    private static Teammate mate(RunPlan plan, RobotSpec spec) {
        Entity body = plan.scene().robotBodies().get(spec.id());
        return new Teammate(spec, body == null ? Optional.of(spec.model().body()) : Entity.look(body.blocks()));
    }

    /// A robot of a model that nobody planned.
    private static Teammate mate(RobotModel model) {
        var spec = new RobotSpec(model.name(), model.name(), model, Optional.empty(), RobotColors.of(0));
        return new Teammate(spec, Optional.of(model.body()));
    }

    /// Where messages about the devices of a robot are held.
    static String devices(String robot) {
        return ChannelNames.about(ChannelNames.DEVICES, robot) + "\n";
    }

    /// What a channel is of.
    void reads(String topic, ReadingType<?> type) {
        types.put(topic, type);
    }

    /// Of a run of which no state was recorded.
    Snapshot nothing() {
        return new Snapshot(
                0,
                Duration.ZERO,
                true,
                false,
                1,
                0,
                Optional.empty(),
                List.of(),
                List.of(),
                planned,
                List.of(),
                Answer.Linked.NONE);
    }

    Snapshot snapshot(NewestRecords held, Duration time, Optional<String> outcome) {
        now = new IdentityHashMap<>();
        Optional<MessageFields> state = read(held, ChannelNames.STATE, Own.STATE, (fields, _) -> fields);
        var devices = new HashMap<String, List<Recorded>>(); // by robot
        var mates = new ArrayList<Teammate>();
        var agents = new ArrayList<AgentView>();
        var things = new ArrayList<Standing>();
        held.messages().keySet().forEach(key -> {
            if (key.startsWith(ChannelNames.about(ChannelNames.DEVICES, ""))) {
                read(held, key, Own.DEVICE, (fields, _) -> fields)
                        .ifPresent(fields -> devices.computeIfAbsent(fields.text("robot"), _ -> new ArrayList<>())
                                .add(device(fields)));
            } else if (key.startsWith(ChannelNames.about(ChannelNames.ROBOTS, ""))) {
                read(held, key, Own.ROBOT, (fields, _) -> mate(fields)).ifPresent(mates::add);
            } else if (key.startsWith(ChannelNames.about(ChannelNames.AGENTS, ""))) {
                read(held, key, Own.AGENT, (fields, _) -> fields)
                        .ifPresent(fields -> agents.add(agent(fields, held.speech(fields.text("name")))));
            } else if (key.startsWith(ChannelNames.about(ChannelNames.THINGS, ""))) {
                read(held, key, Own.THING, (fields, _) -> thing(fields))
                        .flatMap(standing -> standing)
                        .ifPresent(things::add);
            }
        });
        var team = new LinkedHashMap<String, Teammate>();
        mates.forEach(mate -> team.put(mate.spec().id(), mate));
        var robots = new ArrayList<RobotView>();
        for (MessageFields robot : state.map(all -> all.all("robots")).orElse(List.of())) {
            String id = robot.text("id");
            Teammate mate = team.get(id);
            if (mate != null) {
                robots.add(robot(robot, mate.spec(), held, devices.getOrDefault(id, List.of()), time));
            }
        }
        Answer.Linked links = read(held, ChannelNames.LINKS, Own.LINKS, (fields, _) -> links(fields))
                .orElse(Answer.Linked.NONE);
        before = now;
        return new Snapshot(
                0,
                time,
                true,
                state.map(fields -> fields.flag("stopped")).orElse(false),
                1,
                0,
                outcome,
                robots,
                agents,
                List.copyOf(team.values()),
                things,
                links);
    }

    private static Answer.Linked links(MessageFields fields) {
        List<Link> links = fields.all("links").stream()
                .map(link -> new Link(
                        link.text("one"),
                        link.text("other"),
                        new Link.Way(link.flag("there"), link.flag("said_there")),
                        new Link.Way(link.flag("back"), link.flag("said_back"))))
                .toList();
        return new Answer.Linked(links, fields.flag("too_many"));
    }

    /// Where robots are, by their names: as people are shown them.
    ///
    /// @param state an [Own#STATE]
    static Map<String, Pose2d> poses(MessageFields state) {
        var poses = new HashMap<String, Pose2d>();
        for (MessageFields robot : state.all("robots")) {
            robot.pose("truth")
                    .or(() -> robot.within("estimate").flatMap(belief -> belief.pose("pose")))
                    .or(() -> robot.pose("stand_in"))
                    .ifPresent(pose -> poses.put(robot.text("id"), pose));
        }
        return poses;
    }

    /// What devices of a robot had told last; nothing of one that was not there.
    List<Reading> readings(NewestRecords held, Duration time, String robot) {
        now = new IdentityHashMap<>();
        var devices = new ArrayList<Recorded>();
        held.messages().keySet().stream()
                .filter(key -> key.startsWith(devices(robot)))
                .forEach(key -> read(held, key, Own.DEVICE, (fields, _) -> device(fields))
                        .ifPresent(devices::add));
        List<Reading> readings = read(held, ChannelNames.STATE, Own.STATE, (fields, _) -> fields)
                .flatMap(state -> state.all("robots").stream()
                        .filter(one -> one.text("id").equals(robot))
                        .findFirst())
                .map(one -> reported(one, robot, held, devices, start.plus(time)).readings)
                .orElse(List.of());
        before = now;
        return readings;
    }

    Optional<Mind.View> mind(NewestRecords held, String agent) {
        return read(held, ChannelNames.about(ChannelNames.MINDS, agent), Own.MIND, (fields, _) -> mind(fields));
    }

    /// What a message says, read once for as long as it is the newest of its kind.
    private <T> Optional<T> read(NewestRecords held, String key, MessageType type, Reader<T> reader) {
        Raw raw = held.messages().get(key);
        if (raw == null) {
            return Optional.empty();
        }
        Optional<Object> known = before.get(raw);
        if (known == null) {
            known = made(raw, type, reader);
        }
        now.put(raw, known);
        @SuppressWarnings("unchecked") // messages of one key are read by one reader
        Optional<T> value = (Optional<T>) known;
        return value;
    }

    private static Optional<Object> made(Raw raw, MessageType type, Reader<?> reader) {
        try {
            return Optional.of(reader.read(MessageFields.read(type, raw.buffer()), time(raw)));
        } catch (IOException | IllegalArgumentException _) {
            return Optional.empty(); // not what we wrote
        }
    }

    private static Instant time(Raw raw) {
        return Instant.ofEpochSecond(Math.floorDiv(raw.time(), SECOND), Math.floorMod(raw.time(), SECOND));
    }

    /// What it looks like is planned: by its name, else as the others of its model, else as the program has that.
    private Teammate mate(MessageFields fields) {
        String id = fields.text("id");
        if (UNFIT.matcher(id).find()) { // it becomes the name of files
            throw new IllegalArgumentException("No robot is called '%s'.".formatted(id));
        }
        Optional<Teammate> same = planned.stream()
                .filter(mate -> mate.spec().id().equals(id))
                .findFirst()
                .or(() -> planned.stream()
                        .filter(mate -> mate.spec().model().name().equals(fields.text("model"))
                                && mate.spec().role().equals(fields.text("role")))
                        .findFirst())
                .or(() -> planned.stream()
                        .filter(mate -> mate.spec().model().name().equals(fields.text("model")))
                        .findFirst())
                .or(() -> RobotModels.readBuiltIn().stream()
                        .filter(model -> model.name().equals(fields.text("model")))
                        .findFirst()
                        .map(Decoder::mate));
        Teammate like = same.orElseThrow(() -> new IllegalArgumentException("No robot is like it."));
        String color = Rgb.parse(fields.text("color"))
                .map(Rgb::toString)
                .orElse(like.spec().color());
        return new Teammate(
                new RobotSpec(
                        id, fields.text("role"), like.spec().model(), Optional.empty(), color, OptionalInt.empty()),
                like.body());
    }

    private RobotView robot(
            MessageFields robot, RobotSpec spec, NewestRecords held, List<Recorded> devices, Duration time) {
        String id = spec.id();
        Instant when = start.plus(time);
        Reported reported = reported(robot, id, held, devices, when);
        return new RobotView(
                id,
                spec.role(),
                spec.color(),
                spec.model().name(),
                robot.flag("gone"),
                Optional.of(duration(robot, "gone_for")).filter(Duration::isPositive),
                robot.pose("truth"),
                reported.odometry,
                reported.estimate,
                reading(
                        held,
                        id,
                        ChannelNames.PARTICLES,
                        robot.texts("lacks"),
                        Foxglove.POINT_CLOUD,
                        Decoder::particles),
                reported.scan,
                reported.ranges,
                reported.map,
                path(held, id, ChannelNames.PATH),
                path(held, id, ChannelNames.LOCAL_PATH),
                robot.pose("goal"),
                robot.text("in_charge"),
                robot.text("behavior"),
                robot.text("driver"),
                Optional.of(robot)
                        .filter(has -> has.flag("has_gripper"))
                        .map(has -> gripper(reported.readings)
                                .orElseGet(() -> new Stamped<>(when, id + "/gripper", gripper(has)))),
                robot.flag("stopped"),
                robot.flag("switched_off"),
                robot.flag("lit"),
                robot.all("carried").stream().map(Decoder::carried).toList(),
                Optional.of(robot)
                        .filter(all -> all.flag("real") || all.pose("stand_in").isPresent())
                        .map(Decoder::real),
                devices.stream().map(Recorded::view).toList(),
                reported.readings);
    }

    private Reported reported(
            MessageFields robot, String id, NewestRecords held, List<Recorded> devices, Instant when) {
        List<String> lacks = robot.texts("lacks");
        Optional<Stamped<Odometry>> odometry = robot.pose("odometry")
                .map(pose -> new Odometry(
                        pose,
                        new Twist2d(robot.number("vx"), robot.number("vy"), robot.number("omega")),
                        robot.flag("stalled")))
                .map(moved -> new Stamped<>(when, id + "/odom", moved));
        Optional<Stamped<PoseEstimate>> estimate = robot.within("estimate")
                .map(belief -> new Stamped<>(
                        Optional.ofNullable(held.messages().get(ChannelNames.of(id, ChannelNames.ESTIMATE)))
                                .map(Decoder::time)
                                .orElse(when),
                        belief.text("frame_id"),
                        belief.estimate()));
        Optional<Stamped<LaserScan>> scan = drawn(held, id, ChannelNames.SCAN, lacks, LaserScan.class);
        Optional<Stamped<RangeArray>> ranges = drawn(held, id, ChannelNames.RANGES, lacks, RangeArray.class);
        Optional<Stamped<OccupancyGrid>> map = reading(held, id, ChannelNames.MAP, lacks, Foxglove.GRID, Decoder::grid);
        var drawn = Map.of(
                ChannelNames.STATE,
                odometry,
                ChannelNames.of(id, ChannelNames.ESTIMATE),
                estimate,
                ChannelNames.of(id, ChannelNames.SCAN),
                scan,
                ChannelNames.of(id, ChannelNames.RANGES),
                ranges,
                ChannelNames.of(id, ChannelNames.MAP),
                map);
        var readings = new ArrayList<Reading>();
        for (Recorded device : devices) {
            String topic = device.topic().isEmpty() ? usualTopic(id, device, devices) : device.topic();
            Optional<? extends Stamped<?>> value = drawn.get(topic);
            (value == null ? reported(held, device, lacks) : value)
                    .map(reported ->
                            new Reading(device.view().name(), reported, Duration.between(reported.time(), when)))
                    .ifPresent(readings::add);
        }
        return new Reported(odometry, estimate, scan, ranges, map, readings);
    }

    /// What a device told that has a topic of its own kind.
    private <T> Optional<Stamped<T>> drawn(
            NewestRecords held, String robot, String what, List<String> lacks, Class<T> reported) {
        ReadingType<?> type = types.get(ChannelNames.of(robot, what));
        return type == null || !type.reported().equals(reported)
                ? Optional.empty()
                : reading(
                                held,
                                robot,
                                what,
                                lacks,
                                type.message(),
                                (fields, taken) -> type.read(fields, taken, reported))
                        .map(one -> one.value() instanceof LaserScan
                                ? new Stamped<>(one.time(), robot + "/laser", one.value())
                                : one);
    }

    /// What a device told for itself alone.
    private Optional<? extends Stamped<?>> reported(NewestRecords held, Recorded device, List<String> lacks) {
        ReadingType<?> type = types.get(device.topic());
        return type == null
                        || lacks.contains(ChannelNames.DEVICE + device.view().name())
                ? Optional.empty()
                : read(held, device.topic(), type.message(), type::read);
    }

    /// Of a recording that does not say where what a device told is: of several of a type it is the first that is
    /// drawn.
    private static String usualTopic(String robot, Recorded device, List<Recorded> devices) {
        String type = device.view().type();
        boolean first = devices.stream()
                .filter(other -> other.view().type().equals(type))
                .findFirst()
                .equals(Optional.of(device));
        return switch (first ? type : "") { // as DeviceView calls them
            case "DriveBase" -> ChannelNames.STATE;
            case "LaserScanner" -> ChannelNames.of(robot, ChannelNames.SCAN);
            case "SonarArray" -> ChannelNames.of(robot, ChannelNames.RANGES);
            case "Localizer" -> ChannelNames.of(robot, ChannelNames.ESTIMATE);
            default -> "";
        };
    }

    private static Optional<Stamped<GripperState>> gripper(List<Reading> readings) {
        return readings.stream()
                .map(Reading::value)
                .filter(reported -> reported.value() instanceof GripperState)
                .map(reported -> new Stamped<>(reported.time(), reported.frame(), (GripperState) reported.value()))
                .findFirst();
    }

    private <T> Optional<Stamped<T>> reading(
            NewestRecords held,
            String robot,
            String what,
            List<String> lacks,
            MessageType type,
            Reader<Stamped<T>> reader) {
        return lacks.contains(what) ? Optional.empty() : read(held, ChannelNames.of(robot, what), type, reader);
    }

    /// Of an older recording, which has only what is drawn.
    private static GripperState gripper(MessageFields robot) {
        return new GripperState(
                GripperState.Paddles.STOPPED,
                robot.number("gripper_closed"),
                GripperState.Lift.STOPPED,
                robot.number("gripper_raised"),
                false,
                false,
                false,
                false,
                robot.flag("gripper_holding"));
    }

    private static Carried carried(MessageFields load) {
        return new Carried(
                load.texts("devices"),
                Arrays.stream(load.doubles("pieces"))
                        .mapToObj(piece -> (int) piece)
                        .toList(),
                load.pose("pose").orElse(Pose2d.ORIGIN),
                load.number("rise"));
    }

    private static RobotView.Real real(MessageFields robot) {
        return new RobotView.Real(robot.flag("proxy"), robot.pose("stand_in"), Optional.of(duration(robot, "silence")));
    }

    /// Of a number of seconds.
    private static Duration duration(MessageFields fields, String name) {
        double seconds = Math.clamp(fields.number(name), 0, 1e9); // NaN becomes NaN, and that 0
        return Duration.ofNanos((long) (seconds * 1e9));
    }

    private static Stamped<ParticleCloud> particles(MessageFields fields, Instant taken) {
        ByteBuffer data = ByteBuffer.wrap(fields.bytes("data")).order(ByteOrder.LITTLE_ENDIAN);
        int count = data.remaining() / 16;
        float[] poses = new float[3 * count];
        float[] weights = new float[count];
        for (int i = 0; i < count; i++) {
            for (int j = 0; j < 3; j++) {
                poses[3 * i + j] = data.getFloat();
            }
            weights[i] = data.getFloat();
        }
        return new Stamped<>(taken, fields.text("frame_id"), new ParticleCloud(poses, weights));
    }

    private static Stamped<OccupancyGrid> grid(MessageFields fields, Instant taken) {
        return new Stamped<>(taken, fields.text("frame_id"), grid(fields));
    }

    /// @param fields of a [Foxglove#GRID]
    /// @throws IllegalArgumentException when it has no cells, or too few for its last row
    static OccupancyGrid grid(MessageFields fields) {
        byte[] cells = fields.bytes("data");
        int width = Math.clamp(fields.count("column_count"), 1, Integer.MAX_VALUE);
        Pose2d corner = fields.foxglovePose("pose");
        double resolution =
                fields.within("cell_size").map(size -> size.number("x")).orElse(0.0);
        return new OccupancyGrid(width, cells.length / width, resolution, corner.x(), corner.y(), cells);
    }

    private Path2d path(NewestRecords held, String robot, String what) {
        return read(held, ChannelNames.of(robot, what), Foxglove.SCENE_UPDATE, (fields, _) -> path(fields))
                .orElse(Path2d.EMPTY);
    }

    private static Path2d path(MessageFields fields) {
        return new Path2d(fields.all("entities").stream()
                .flatMap(entity -> entity.all("lines").stream())
                .flatMap(line -> line.all("points").stream())
                .map(point -> new Point2d(point.number("x"), point.number("y")))
                .toList());
    }

    private static Recorded device(MessageFields fields) {
        Health health = switch (fields.text("health")) {
            case "OK" -> Health.ok();
            case "STALE" -> new Health.Stale(fields.text("reason"));
            default -> new Health.Lost(fields.text("reason"));
        };
        return new Recorded(
                new DeviceView(fields.text("name"), fields.text("driver"), fields.text("type"), health),
                fields.text("topic"));
    }

    private AgentView agent(MessageFields fields, Speech speech) {
        var entry = new Directory.Entry(
                fields.text("name"), fields.text("role"), fields.text("type"), fields.text("robot"), "");
        return new AgentView(
                new AgentPlatform.View(
                        entry,
                        fields.word(AgentPlatform.Status.class, "status", AgentPlatform.Status.ENDED),
                        fields.text("state"),
                        pairs(fields.all("beliefs")),
                        speech.sent()),
                speech.last(),
                speech.time().map(time -> Duration.between(start, Instant.ofEpochSecond(0, time))));
    }

    /// What an agent shows of itself, which says nothing of what it wants.
    static Mind.View shown(MessageFields agent) {
        return new Mind.View(pairs(agent.all("beliefs")), List.of());
    }

    static Mind.View mind(MessageFields fields) {
        return new Mind.View(
                pairs(fields.all("beliefs")),
                fields.all("goals").stream()
                        .map(goal -> new Mind.GoalView(
                                goal.text("name"),
                                goal.word(Mind.GoalState.class, "state", Mind.GoalState.NOT_WANTED),
                                goal.number("urgency"),
                                goal.texts("plans"),
                                goal.texts("steps"),
                                goal.text("failure")))
                        .toList());
    }

    private static Map<String, String> pairs(List<MessageFields> all) {
        var pairs = new LinkedHashMap<String, String>();
        all.forEach(pair -> pairs.put(pair.text("key"), pair.text("value")));
        return pairs;
    }

    /// Empty when it is gone.
    private static Optional<Standing> thing(MessageFields fields) {
        if (fields.flag("gone")) {
            return Optional.empty();
        }
        List<Prism> pieces = fields.all("pieces").stream().map(Decoder::piece).toList();
        return Optional.of(new Standing(
                (int) fields.count("number"),
                fields.text("name"),
                new Solid(pieces),
                fields.pose("pose").orElse(Pose2d.ORIGIN),
                fields.number("height"),
                fields.flag("grippable")));
    }

    private static Prism piece(MessageFields piece) {
        double[] corners = piece.doubles("corners");
        var points = new ArrayList<Point2d>();
        for (int i = 0; i + 1 < corners.length; i += 2) {
            points.add(new Point2d(corners[i], corners[i + 1]));
        }
        double radius = piece.number("radius");
        Shape shape = radius > 0 && points.size() == 1
                ? new Shape.Disc(points.getFirst(), radius)
                : new Shape.Polygon(points);
        return new Prism(shape, piece.number("bottom"), piece.number("top"), Rgb.parse(piece.text("color")));
    }
}
