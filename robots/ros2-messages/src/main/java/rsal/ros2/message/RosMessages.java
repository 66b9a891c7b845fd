package rsal.ros2.message;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import rsal.data.ActuatorState;
import rsal.data.BatteryState;
import rsal.data.Covariance2d;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Twist2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform.Quaternion;

/// Values of ours as messages of ROS 2, in CDR. All of their types are the same in Humble, Jazzy, Kilted and
/// Lyrical. Of one thread.
public final class RosMessages {
    private static final int COVARIANCES = 36; // of x, y, z, and turns about these axes
    private static final long SECOND = 1_000_000_000; // ns
    private static final float SECONDS_PER_HOUR = 3_600;
    private static final double NOMINAL = 12; // V, of batteries that don't tell

    private final CdrWriter writer = new CdrWriter();
    private final UnaryOperator<Instant> stamps;

    /// With the times that they are made of.
    public RosMessages() {
        this(UnaryOperator.identity());
    }

    /// @param stamps says which time messages have that are made of a time
    public RosMessages(UnaryOperator<Instant> stamps) {
        this.stamps = stamps;
    }

    /// Where a frame is in another one.
    public record Transform(Instant time, String parent, String child, FrameTransform parentFromChild) {}

    private CdrWriter header(Instant time, String frame) {
        return write(writer, stamps.apply(time)).text(frame);
    }

    /// `builtin_interfaces/Time`
    public static CdrWriter write(CdrWriter to, Instant time) {
        return to.int32((int) time.getEpochSecond()).int32(time.getNano());
    }

    /// `geometry_msgs/Twist`
    public byte[] twist(Twist2d velocity) {
        writer.clear();
        write(velocity);
        return writer.toBytes();
    }

    /// `geometry_msgs/TwistStamped`
    ///
    /// @param frame of the robot
    public byte[] twist(Twist2d velocity, Instant time, String frame) {
        writer.clear();
        header(time, frame);
        write(velocity);
        return writer.toBytes();
    }

    private void write(Twist2d velocity) {
        writer.float64(velocity.vx()).float64(velocity.vy()).float64(0);
        writer.float64(0).float64(0).float64(velocity.omega());
    }

    private void write(FrameTransform transform) {
        write(writer, transform);
    }

    /// `geometry_msgs/Pose` or `geometry_msgs/Transform`
    public static CdrWriter write(CdrWriter to, FrameTransform transform) {
        Quaternion turned = transform.rotation();
        return to.float64(transform.x())
                .float64(transform.y())
                .float64(transform.z())
                .float64(turned.x())
                .float64(turned.y())
                .float64(turned.z())
                .float64(turned.w());
    }

    /// `nav_msgs/Odometry`, with covariances of 0, which is to say unknown.
    public byte[] odometry(Instant time, Odometry odometry, String frame, String childFrame) {
        writer.clear();
        header(time, frame).text(childFrame);
        write(FrameTransform.of(odometry.odomFromBase()));
        writer.float64s(new double[COVARIANCES]);
        write(odometry.velocity());
        writer.float64s(new double[COVARIANCES]);
        return writer.toBytes();
    }

    /// `sensor_msgs/LaserScan`
    ///
    /// @param period from one scan to the next [s]; 0 where it is unknown
    public byte[] scan(Instant time, LaserScan scan, String frame, double period) {
        writer.clear();
        header(time, frame)
                .float32((float) scan.angleMin())
                .float32((float) scan.angle(scan.count() - 1))
                .float32((float) scan.angleIncrement())
                .float32(0)
                .float32((float) period)
                .float32((float) scan.rangeMin())
                .float32((float) scan.rangeMax())
                .int32(scan.count())
                .float32s(scan.ranges())
                .int32(0); // no intensities
        return writer.toBytes();
    }

    /// `sensor_msgs/Range` of one sonar. Its last field came with Jazzy; older programs ignore it.
    public byte[] range(Instant time, RangeArray ranges, int sensor, String frame) {
        writer.clear();
        header(time, frame)
                .int8((byte) 0) // ultrasound
                .float32((float) ranges.fieldOfView())
                .float32((float) ranges.rangeMin())
                .float32((float) ranges.rangeMax())
                .float32(ranges.ranges()[sensor])
                .float32(0); // an unknown variance
        return writer.toBytes();
    }

    /// `tf2_msgs/TFMessage`
    public byte[] transforms(List<Transform> transforms) {
        writer.clear().int32(transforms.size());
        for (Transform each : transforms) {
            header(each.time, each.parent).text(each.child);
            write(each.parentFromChild);
        }
        return writer.toBytes();
    }

    /// `geometry_msgs/PoseWithCovarianceStamped`
    public byte[] pose(Instant time, PoseEstimate estimate, String frame) {
        writer.clear();
        header(time, frame);
        write(FrameTransform.of(estimate.mapFromBase()));
        Covariance2d spread = estimate.covariance();
        var all = new double[COVARIANCES];
        all[0] = spread.xx();
        all[1] = spread.xy();
        all[5] = spread.xTheta();
        all[6] = spread.xy();
        all[7] = spread.yy();
        all[11] = spread.yTheta();
        all[30] = spread.xTheta();
        all[31] = spread.yTheta();
        all[35] = spread.thetaTheta();
        writer.float64s(all);
        return writer.toBytes();
    }

    /// `geometry_msgs/PoseStamped`
    public byte[] pose(Instant time, Pose2d pose, String frame) {
        writer.clear();
        header(time, frame);
        write(FrameTransform.of(pose));
        return writer.toBytes();
    }

    /// The name of a frame, without the slash with which old ones begin.
    public static String frame(String name) {
        return name.startsWith("/") ? name.substring(1) : name;
    }

    /// When a message is from, by its `std_msgs/Header` [ns].
    public static long stamp(RosMessage header) {
        RosMessage stamp = header.message("stamp");
        return stamp.integer("sec") * SECOND + stamp.integer("nanosec");
    }

    /// The next `builtin_interfaces/Time` [ns].
    public static long stamp(CdrReader bytes) throws InvalidCdr {
        long seconds = bytes.int32();
        return seconds * SECOND + Integer.toUnsignedLong(bytes.int32());
    }

    /// The next `geometry_msgs/Twist`, in the plane.
    public static Twist2d twist(CdrReader bytes) throws InvalidCdr {
        double vx = bytes.float64();
        double vy = bytes.float64();
        bytes.skip(Double.BYTES, 3); // upwards, and turning about the other axes
        return new Twist2d(vx, vy, bytes.float64());
    }

    /// What a `geometry_msgs/PoseWithCovarianceStamped` says, in the plane; empty when it has values that are
    /// no numbers.
    public static Optional<PoseEstimate> estimate(RosMessage message) {
        RosMessage with = message.message("pose");
        FrameTransform pose = FrameTransform.of(with.message("pose"), "position", "orientation");
        double[] all = with.get("covariance", double[].class);
        var spread = new Covariance2d(all[0], all[1], all[5], all[7], all[11], all[35]);
        return Optional.of(PoseEstimate.of(pose.planar(), spread)).filter(PoseEstimate::isFinite);
    }

    /// `sensor_msgs/BatteryState`, which has charges in Ah: of a battery that knows no voltage, at 12 V.
    public byte[] battery(Instant time, BatteryState state, String frame) {
        double voltage = Double.isNaN(state.voltage()) ? NOMINAL : state.voltage();
        double perHour = SECONDS_PER_HOUR * voltage;
        writer.clear();
        header(time, frame)
                .float32((float) voltage)
                .float32(Float.NaN) // temperature
                .float32((float) (state.power() / voltage))
                .float32((float) (state.charge() / perHour))
                .float32((float) (state.capacity() / perHour))
                .float32(Float.NaN) // by design
                .float32((float) state.level())
                .int8(status(state))
                .int8((byte) 0) // health
                .int8((byte) 0) // technology
                .bool(true)
                .int32(0) // cells' voltages
                .int32(0) // cells' temperatures
                .text("")
                .text("");
        return writer.toBytes();
    }

    private static byte status(BatteryState state) {
        return switch (state.charging()) {
            case UNKNOWN -> 0;
            case CHARGING -> 1;
            case DISCHARGING, GIVING -> 2;
            case FULL -> 4;
        };
    }

    /// `nav_msgs/OccupancyGrid`
    public byte[] map(Instant time, OccupancyGrid map, String frame) {
        var origin = new Pose2d(map.originX(), map.originY(), 0);
        writer.clear();
        write(header(time, frame), stamps.apply(time)) // when it was loaded
                .float32((float) map.resolution())
                .int32(map.width())
                .int32(map.height());
        write(FrameTransform.of(origin));
        byte[] cells = map.cells(); // their values and order are those of ROS
        writer.int32(cells.length).int8s(cells);
        return writer.toBytes();
    }

    /// `std_msgs/String`
    public byte[] text(String text) {
        return writer.clear().text(text).toBytes();
    }

    /// `sensor_msgs/JointState`, without efforts, which nobody knows.
    ///
    /// @param joints by name
    public byte[] joints(Instant time, Map<String, ActuatorState> joints) {
        writer.clear();
        header(time, "").int32(joints.size());
        joints.keySet().forEach(writer::text);
        writer.int32(joints.size());
        joints.values().forEach(joint -> writer.float64(joint.position()));
        writer.int32(joints.size());
        joints.values().forEach(joint -> writer.float64(joint.speed()));
        return writer.int32(0).toBytes();
    }

    /// `rosgraph_msgs/Clock`
    public byte[] clock(Instant time) {
        return write(writer.clear(), stamps.apply(time)).toBytes();
    }
}
