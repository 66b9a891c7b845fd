package rsal.recording;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Stream;
import rsal.behavior.Decision;
import rsal.behavior.Decision.Opinion;
import rsal.data.ActuatorState;
import rsal.data.BatteryState;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.BumperState;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.GripperState;
import rsal.data.Interval;
import rsal.data.LaserScan;
import rsal.data.LightState;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Planner;
import rsal.engine.report.NavigatorState;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.ProtoWriter;
import rsal.robot.DeviceKinds;

/// How what a device tells is written and read again. Names of fields and their meanings are those of the records, and
/// of scans Foxglove's.
///
/// @param reported what the device tells
/// @param message which has a timestamp, a frame, and its own fields from 3 on
/// @param writer of these
/// @param reader of these
record ReadingType<T>(
        Class<T> reported, MessageType message, BiConsumer<ProtoWriter, T> writer, Function<MessageFields, T> reader) {
    private static final ReadingType<ActuatorState> ACTUATOR =
            new ReadingType<>(ActuatorState.class, Own.ACTUATOR_STATE, ReadingType::write, ReadingType::actuator);
    private static final ReadingType<BatteryState> BATTERY =
            new ReadingType<>(BatteryState.class, Own.BATTERY_STATE, ReadingType::write, ReadingType::battery);
    private static final ReadingType<Blobs> BLOBS =
            new ReadingType<>(Blobs.class, Own.BLOBS, ReadingType::write, ReadingType::blobs);
    private static final ReadingType<BumperState> BUMPERS =
            new ReadingType<>(BumperState.class, Own.BUMPER_STATE, ReadingType::write, ReadingType::bumpers);
    private static final ReadingType<Decision> DECISION =
            new ReadingType<>(Decision.class, Own.DECISION, ReadingType::write, ReadingType::decision);
    private static final ReadingType<Fiducials> FIDUCIALS =
            new ReadingType<>(Fiducials.class, Own.FIDUCIALS, ReadingType::write, ReadingType::fiducials);
    private static final ReadingType<GripperState> GRIPPER =
            new ReadingType<>(GripperState.class, Own.GRIPPER_STATE, ReadingType::write, ReadingType::gripper);
    private static final ReadingType<LightState> LIGHT =
            new ReadingType<>(LightState.class, Own.LIGHT_STATE, ReadingType::write, ReadingType::light);
    private static final ReadingType<NavigatorState> NAVIGATOR =
            new ReadingType<>(NavigatorState.class, Own.NAVIGATOR_STATE, ReadingType::write, ReadingType::navigator);
    private static final ReadingType<Planner.Asked> PLANNER =
            new ReadingType<>(Planner.Asked.class, Own.PLANNER_ASKED, ReadingType::write, ReadingType::asked);

    private static final ReadingType<LaserScan> SCAN = laser(Optional.empty());
    private static final ReadingType<RangeArray> RANGES =
            new ReadingType<>(RangeArray.class, Own.RANGES, ReadingType::write, ReadingType::ranges);
    private static final ReadingType<OccupancyGrid> MAP =
            new ReadingType<>(OccupancyGrid.class, Foxglove.GRID, Foxglove::grid, Decoder::grid);
    private static final ReadingType<PoseEstimate> ESTIMATE =
            new ReadingType<>(PoseEstimate.class, Own.POSE_ESTIMATE, ReadingType::write, MessageFields::estimate);
    private static final ReadingType<Odometry> ODOMETRY =
            new ReadingType<>(Odometry.class, Own.ODOMETRY, ReadingType::write, ReadingType::odometry);
    private static final ReadingType<Quantities> QUANTITIES =
            new ReadingType<>(Quantities.class, Own.QUANTITIES, ReadingType::write, ReadingType::quantities);

    private static final String LEAST = "range_min"; // of what channels of lasers tell
    private static final String MOST = "range_max";

    /// Those that are written here.
    static final List<ReadingType<?>> WRITTEN = List.of(
            ACTUATOR,
            BATTERY,
            BLOBS,
            BUMPERS,
            DECISION,
            FIDUCIALS,
            GRIPPER,
            LIGHT,
            NAVIGATOR,
            PLANNER,
            SCAN,
            RANGES,
            MAP,
            ESTIMATE,
            ODOMETRY,
            QUANTITIES);

    /// All there are, those of registered kinds of devices last.
    static final List<ReadingType<?>> ALL = Stream.concat(
                    WRITTEN.stream(), DeviceKinds.all().stream().map(kind -> of(kind.reads())))
            .toList();

    private static <T> ReadingType<T> of(Class<T> reported) {
        RecordCodec<T> codec = RecordCodec.of(reported, Own.reading(reported.getName()), 3);
        return new ReadingType<>(reported, codec.message(), codec::write, codec::read);
    }

    /// Of what a device tells; empty when nobody thought of that here.
    static Optional<ReadingType<?>> of(Object value) {
        for (ReadingType<?> type : ALL) { // for each reading of a run: no stream
            if (type.reported.isInstance(value)) {
                return Optional.of(type);
            }
        }
        return Optional.empty();
    }

    /// @param schema name of a kind of messages
    static Optional<ReadingType<?>> named(String schema) {
        return ALL.stream().filter(type -> type.message.name().equals(schema)).findFirst();
    }

    /// @param about what the channel of such messages tells of its device
    static Optional<ReadingType<?>> of(String schema, Map<String, String> about) {
        return named(schema).map(type -> type.equals(SCAN) ? laser(limits(about)) : type);
    }

    /// @param limits shortest and longest range that it measures [m]; empty where nobody knows
    private static ReadingType<LaserScan> laser(Optional<Interval> limits) {
        return new ReadingType<>(
                LaserScan.class, Foxglove.LASER_SCAN, ReadingType::write, fields -> scan(fields, limits));
    }

    /// What the channel of a laser tells, once.
    static Map<String, String> limits(LaserScan laser) {
        var limits = new TreeMap<String, String>(); // so that equal runs are equal files
        limits.put(LEAST, Double.toString(laser.rangeMin()));
        limits.put(MOST, Double.toString(laser.rangeMax()));
        return limits;
    }

    private static Optional<Interval> limits(Map<String, String> about) {
        try {
            double least = Double.parseDouble(about.getOrDefault(LEAST, ""));
            double most = Double.parseDouble(about.getOrDefault(MOST, ""));
            return least >= 0 && most > least && Double.isFinite(most)
                    ? Optional.of(new Interval(least, most))
                    : Optional.empty();
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }

    void write(ProtoWriter out, Object value) {
        writer.accept(out, reported.cast(value));
    }

    /// @throws IllegalArgumentException when no device tells that
    Stamped<T> read(MessageFields fields, Instant taken) {
        return new Stamped<>(taken, fields.text("frame_id"), reader.apply(fields));
    }

    /// The same, of which is known what it is.
    ///
    /// @param known that
    <K> Stamped<K> read(MessageFields fields, Instant taken, Class<K> known) {
        return new Stamped<>(taken, fields.text("frame_id"), known.cast(reader.apply(fields)));
    }

    private static void write(ProtoWriter out, LaserScan scan) {
        Foxglove.pose(out, 3, scan.baseFromLaser());
        out.number(4, scan.angleMin());
        out.number(5, scan.angle(Math.max(0, scan.count() - 1)));
        out.numbers(6, scan.ranges());
    }

    private static LaserScan scan(MessageFields fields, Optional<Interval> limits) {
        float[] ranges = fields.floats("ranges");
        double first = fields.number("start_angle");
        double increment = ranges.length < 2 ? 0 : (fields.number("end_angle") - first) / (ranges.length - 1);
        Interval known = limits.orElseGet(() -> new Interval(0, greatest(ranges)));
        return new LaserScan(fields.foxglovePose("pose"), first, increment, known.least(), known.most(), ranges);
    }

    private static double greatest(float[] ranges) {
        double greatest = 1;
        for (float range : ranges) {
            greatest = Float.isFinite(range) ? Math.max(greatest, range) : greatest;
        }
        return greatest;
    }

    private static void write(ProtoWriter out, RangeArray array) {
        out.number(3, array.fieldOfView());
        out.number(4, array.rangeMin());
        out.number(5, array.rangeMax());
        array.baseFromSensors().forEach(baseFromSensor -> Own.pose(out, 6, baseFromSensor));
        out.numbers(7, array.ranges());
    }

    private static RangeArray ranges(MessageFields fields) {
        return new RangeArray(
                fields.all("poses").stream().map(MessageFields::pose).toList(),
                fields.number("field_of_view"),
                fields.number("range_min"),
                fields.number("range_max"),
                fields.floats("ranges"));
    }

    private static void write(ProtoWriter out, PoseEstimate belief) {
        Own.pose(out, 3, belief.mapFromBase());
        out.number(4, belief.covariance().xx());
        out.number(5, belief.covariance().xy());
        out.number(6, belief.covariance().yy());
        out.number(7, belief.covariance().thetaTheta());
        out.number(8, belief.confidence());
        out.string(9, belief.quality().name());
        Own.hypotheses(out, 10, belief);
    }

    private static void write(ProtoWriter out, Odometry odometry) {
        Own.pose(out, 3, odometry.odomFromBase());
        Own.twist(out, 4, odometry.velocity());
        out.bool(5, odometry.stalled());
    }

    private static Odometry odometry(MessageFields fields) {
        return new Odometry(mounted(fields), twist(fields), fields.flag("stalled"));
    }

    private static void write(ProtoWriter out, Quantities reported) {
        for (RecordedQuantity quantity : reported.all()) {
            int begun = out.begin(3);
            out.string(1, quantity.name());
            out.string(2, quantity.title());
            out.string(3, quantity.unit());
            out.number(4, quantity.value());
            out.end(begun);
        }
    }

    private static Quantities quantities(MessageFields fields) {
        return new Quantities(fields.all("quantities").stream()
                .limit(Quantities.MOST)
                .map(one -> new RecordedQuantity(
                        one.text("name"), one.text("title"), one.text("unit"), one.number("value")))
                .toList());
    }

    private static void write(ProtoWriter out, ActuatorState state) {
        out.string(3, state.joint().name());
        out.number(4, state.position());
        out.number(5, state.speed());
        out.number(6, state.limits().least());
        out.number(7, state.limits().most());
        out.string(8, state.motion().name());
    }

    private static ActuatorState actuator(MessageFields fields) {
        return new ActuatorState(
                ActuatorState.Joint.valueOf(fields.text("joint")),
                fields.number("position"),
                fields.number("speed"),
                new Interval(fields.number("least"), fields.number("most")),
                ActuatorState.Motion.valueOf(fields.text("motion")));
    }

    private static void write(ProtoWriter out, BatteryState state) {
        out.number(3, state.charge());
        out.number(4, state.capacity());
        out.number(5, state.level());
        out.number(6, state.power());
        out.number(7, state.voltage());
        out.string(8, state.charging().name());
    }

    private static BatteryState battery(MessageFields fields) {
        return new BatteryState(
                fields.number("charge"),
                fields.number("capacity"),
                fields.number("level"),
                fields.number("power"),
                fields.number("voltage"),
                BatteryState.Charging.valueOf(fields.text("charging")));
    }

    private static void write(ProtoWriter out, Blobs seen) {
        Own.pose(out, 3, seen.baseFromCamera());
        out.varint(4, seen.width());
        out.varint(5, seen.height());
        out.number(6, seen.fieldOfView());
        for (Blob blob : seen.blobs()) {
            int begun = out.begin(7);
            out.string(1, blob.color().toString());
            out.varint(2, blob.left());
            out.varint(3, blob.top());
            out.varint(4, blob.right());
            out.varint(5, blob.bottom());
            out.number(6, blob.x());
            out.number(7, blob.y());
            out.varint(8, blob.area());
            out.number(9, blob.range());
            out.end(begun);
        }
    }

    private static Blobs blobs(MessageFields fields) {
        return new Blobs(
                mounted(fields),
                (int) fields.count("width"),
                (int) fields.count("height"),
                fields.number("field_of_view"),
                fields.all("blobs").stream()
                        .map(blob -> new Blob(
                                color(blob),
                                (int) blob.count("left"),
                                (int) blob.count("top"),
                                (int) blob.count("right"),
                                (int) blob.count("bottom"),
                                blob.number("x"),
                                blob.number("y"),
                                (int) blob.count("area"),
                                blob.number("range")))
                        .toList());
    }

    private static void write(ProtoWriter out, BumperState state) {
        for (int i = 0; i < state.pressed().size(); i++) {
            int begun = out.begin(3);
            Own.pose(out, 1, state.baseFromBumpers().get(i));
            out.bool(2, state.pressed().get(i));
            out.end(begun);
        }
    }

    private static BumperState bumpers(MessageFields fields) {
        List<MessageFields> bumpers = fields.all("bumpers");
        return new BumperState(
                bumpers.stream().map(ReadingType::mounted).toList(),
                bumpers.stream().map(bumper -> bumper.flag("pressed")).toList());
    }

    private static void write(ProtoWriter out, Decision decision) {
        Own.twist(out, 3, decision.twist());
        out.string(4, decision.inCharge());
        for (Opinion opinion : decision.opinions()) {
            int begun = out.begin(5);
            out.string(1, opinion.layer());
            Own.twist(out, 2, opinion.twist());
            out.string(3, opinion.state());
            out.end(begun);
        }
    }

    private static Decision decision(MessageFields fields) {
        return new Decision(
                twist(fields),
                fields.text("in_charge"),
                fields.all("opinions").stream()
                        .map(opinion -> new Opinion(opinion.text("layer"), twist(opinion), opinion.text("state")))
                        .toList());
    }

    private static void write(ProtoWriter out, Fiducials seen) {
        Own.pose(out, 3, seen.baseFromFinder());
        out.number(4, seen.fieldOfView());
        out.number(5, seen.rangeMax());
        for (Fiducial marker : seen.fiducials()) {
            int begun = out.begin(6);
            out.bool(1, marker.id().isPresent());
            out.varint(2, marker.id().orElse(0));
            Own.pose(out, 3, marker.baseFromFiducial());
            out.end(begun);
        }
    }

    private static Fiducials fiducials(MessageFields fields) {
        return new Fiducials(
                mounted(fields),
                fields.number("field_of_view"),
                fields.number("range_max"),
                fields.all("fiducials").stream()
                        .map(marker -> new Fiducial(
                                marker.flag("has_id") ? OptionalInt.of((int) marker.count("id")) : OptionalInt.empty(),
                                mounted(marker)))
                        .toList());
    }

    private static void write(ProtoWriter out, GripperState state) {
        out.string(3, state.paddles().name());
        out.number(4, state.closed());
        out.string(5, state.lift().name());
        out.number(6, state.raised());
        out.bool(7, state.innerBeamBroken());
        out.bool(8, state.outerBeamBroken());
        out.bool(9, state.leftContact());
        out.bool(10, state.rightContact());
        out.bool(11, state.holding());
    }

    private static GripperState gripper(MessageFields fields) {
        return new GripperState(
                GripperState.Paddles.valueOf(fields.text("paddles")),
                fields.number("closed"),
                GripperState.Lift.valueOf(fields.text("lift")),
                fields.number("raised"),
                fields.flag("inner_beam_broken"),
                fields.flag("outer_beam_broken"),
                fields.flag("left_contact"),
                fields.flag("right_contact"),
                fields.flag("holding"));
    }

    private static void write(ProtoWriter out, LightState state) {
        out.string(3, state.color().toString());
        out.number(4, state.signal().period().toNanos() / 1e9);
        out.number(5, state.signal().dutyCycle());
        out.bool(6, state.lit());
    }

    private static LightState light(MessageFields fields) {
        var period = Duration.ofNanos(Math.round(fields.number("period") * 1e9));
        return new LightState(
                color(fields), new LightState.Signal(period, fields.number("duty_cycle")), fields.flag("lit"));
    }

    private static void write(ProtoWriter out, NavigatorState state) {
        state.mapFromGoal().ifPresent(goal -> Own.pose(out, 3, goal));
        out.number(4, state.remaining());
        out.bool(5, state.paused());
    }

    private static NavigatorState navigator(MessageFields fields) {
        return new NavigatorState(fields.pose("goal"), fields.number("remaining"), fields.flag("paused"));
    }

    private static void write(ProtoWriter out, Planner.Asked asked) {
        Own.pose(out, 3, asked.mapFromStart());
        Own.pose(out, 4, asked.mapFromGoal());
        out.varint(5, asked.places());
        out.varint(6, asked.reachable());
        out.number(7, asked.cost().orElse(Double.NaN));
        out.number(8, asked.length().orElse(Double.NaN));
        out.string(9, asked.why());
    }

    private static Planner.Asked asked(MessageFields fields) {
        return new Planner.Asked(
                fields.pose("start").orElse(Pose2d.ORIGIN),
                fields.pose("goal").orElse(Pose2d.ORIGIN),
                (int) fields.count("places"),
                (int) fields.count("reachable"),
                known(fields.number("cost")),
                known(fields.number("length")),
                fields.text("why"));
    }

    private static OptionalDouble known(double number) {
        return Double.isNaN(number) ? OptionalDouble.empty() : OptionalDouble.of(number);
    }

    /// Where something is on the base.
    private static Pose2d mounted(MessageFields fields) {
        return fields.pose("pose").orElse(Pose2d.ORIGIN);
    }

    private static Twist2d twist(MessageFields fields) {
        return fields.within("twist")
                .map(twist -> new Twist2d(twist.number("vx"), twist.number("vy"), twist.number("omega")))
                .orElse(Twist2d.STOP);
    }

    private static Rgb color(MessageFields fields) {
        return Rgb.parse(fields.text("color")).orElseThrow(() -> new IllegalArgumentException("A color is #rrggbb."));
    }
}
