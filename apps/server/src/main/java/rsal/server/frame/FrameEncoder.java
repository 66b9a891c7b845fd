package rsal.server.frame;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.GripperState;
import rsal.data.LaserScan;
import rsal.data.ParticleCloud;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.RobotView;
import rsal.engine.report.Snapshot;

/// Writes snapshots as frames: little-endian, every block a multiple of 4 bytes, lengths in millimetres, angles
/// in 1/65536 of a turn. `docs/reference/live-protocol.md` has the offsets.
///
/// Keeps its buffer from frame to frame, so it is for one thread.
public final class FrameEncoder {
    public static final int MAGIC = 0x4c415352; // "RSAL"
    public static final int HEADER_BYTES = 40;
    static final int ROBOT_BYTES = 16;
    static final int THING_BYTES = 16;

    // where these are in the header
    public static final int SEQUENCE_AT = 8;
    public static final int FLAGS_AT = 12;
    public static final int SPEED_AT = 24;
    public static final int RATE_AT = 28;
    private static final int ROBOTS_AT = 32;
    private static final int ROBOT_FLAGS_AT = 14; // of a robot

    public static final int PAUSED = 1;
    static final int STOPPED = 1 << 1;
    public static final int ENDED = 1 << 2;
    public static final int PAST = 1 << 3;
    /// Above them is how often the viewer has looked elsewhere, which begins again at 65536.
    public static final int LOOKS_AT = 16;

    public static final int PRESENT = 1;
    static final int STALLED = 1 << 1;
    static final int TRUTH = 1 << 2;
    static final int ESTIMATE = 1 << 3;
    static final int GOAL = 1 << 4;
    static final int PATH = 1 << 5;
    static final int SCAN = 1 << 6;
    static final int RANGES = 1 << 7;
    static final int PARTICLES = 1 << 8;
    static final int GRIPPER = 1 << 9;
    static final int LIT = 1 << 10;
    static final int ODOM = 1 << 11;
    static final int ELSEWHERE = 1 << 12;
    static final int SIDEWAYS = 1 << 13;
    static final int LOCAL_PATH = 1 << 14;

    static final int HOLDING = 1;

    static final int TOO_CLOSE = 0;
    static final int NOTHING = 0xffff;
    static final int BROKEN = 0xfffe;
    private static final int MAX_RANGE = 0xfffd;

    /// More would not be seen on a screen; of larger clouds every n-th particle is sent.
    static final int MAX_PARTICLES = 1500;

    /// Of what else localizers hold possible, heaviest first.
    private static final int MAX_ELSEWHERE = 20;

    /// An estimate and odometry that are at most so far apart are of one place.
    private static final Duration SAME_TIME = Duration.ofMillis(200);

    private static final double TURN = 2 * Math.PI;

    private ByteBuffer out = allocate(1 << 16);

    /// Is told where a robot is.
    public interface Place {
        /// @param robot its index
        /// @param x [m]
        /// @param y [m]
        void at(int robot, double x, double y);
    }

    /// How many robots a frame has.
    public static int robots(byte[] frame) {
        return in(frame).getInt(ROBOTS_AT);
    }

    /// Tells where the robots of a frame are, of which that is known.
    public static void places(byte[] frame, Place place) {
        ByteBuffer in = in(frame);
        for (int i = 0; i < in.getInt(ROBOTS_AT); i++) {
            int at = HEADER_BYTES + i * ROBOT_BYTES;
            if ((in.getShort(at + ROBOT_FLAGS_AT) & PRESENT) != 0) {
                place.at(i, in.getInt(at) / 1e3, in.getInt(at + Integer.BYTES) / 1e3);
            }
        }
    }

    private static ByteBuffer in(byte[] frame) {
        return ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
    }

    /// @param robots ids, in the order in which the frame has them
    /// @param sequence of the frame, to be acknowledged by
    /// @param moved things that are elsewhere than viewers were told
    public byte[] encode(int run, long sequence, Snapshot snapshot, List<String> robots, List<Standing> moved) {
        Map<String, RobotView> views = HashMap.newHashMap(snapshot.robots().size());
        for (RobotView view : snapshot.robots()) {
            views.put(view.id(), view);
        }
        out.clear();
        header(run, sequence, snapshot, robots.size(), moved.size());
        for (String robot : robots) {
            robot(Optional.ofNullable(views.get(robot)));
        }
        for (String robot : robots) {
            RobotView view = views.get(robot);
            if (view != null) {
                blocks(view);
            }
        }
        moved.forEach(this::thing);
        byte[] frame = new byte[out.position()];
        out.flip().get(frame);
        return frame;
    }

    private void header(int run, long sequence, Snapshot snapshot, int robots, int moved) {
        reserve(HEADER_BYTES);
        out.putInt(MAGIC);
        out.putInt(run);
        out.putInt((int) sequence);
        out.putInt((snapshot.paused() ? PAUSED : 0)
                | (snapshot.stopped() ? STOPPED : 0)
                | (snapshot.outcome().isPresent() ? ENDED : 0));
        out.putDouble(seconds(snapshot.time()));
        out.putFloat((float) snapshot.speed());
        out.putFloat((float) snapshot.rate());
        out.putInt(robots);
        out.putInt(moved);
    }

    private void robot(Optional<RobotView> view) {
        reserve(ROBOT_BYTES);
        Optional<Pose2d> pose = view.flatMap(FrameEncoder::bestPose);
        if (pose.isEmpty()) {
            out.putLong(0).putLong(0);
            return;
        }
        RobotView robot = view.orElseThrow();
        var odometry = robot.odometry().map(Stamped::value);
        pose(pose.get());
        out.putShort(milli(odometry.map(o -> o.velocity().vx()).orElse(0.0)));
        out.putShort(milli(odometry.map(o -> o.velocity().omega()).orElse(0.0)));
        out.putShort(
                (short) (flags(robot) | (odometry.isPresent() && odometry.get().stalled() ? STALLED : 0)));
    }

    private void thing(Standing thing) {
        reserve(THING_BYTES);
        out.putInt(thing.number());
        pose(thing.mapFromThing());
        out.putShort((short) Math.clamp(Math.round(thing.height() * 1000), 0, 0xffff));
    }

    private static int flags(RobotView robot) {
        return PRESENT
                | (robot.truth().isPresent() ? TRUTH : 0)
                | (estimate(robot).isPresent() ? ESTIMATE : 0)
                | (robot.goal().isPresent() ? GOAL : 0)
                | (robot.path().points().isEmpty() ? 0 : PATH)
                | (robot.scan().isPresent() ? SCAN : 0)
                | (robot.ranges().isPresent() ? RANGES : 0)
                | (robot.particles().isPresent() ? PARTICLES : 0)
                | (robot.gripper().isPresent() ? GRIPPER : 0)
                | (robot.lit() ? LIT : 0)
                | (mapFromOdom(robot).isPresent() ? ODOM : 0)
                | (elsewhere(robot).isEmpty() ? 0 : ELSEWHERE)
                | (sideways(robot) == 0 ? 0 : SIDEWAYS)
                | (robot.localPath().points().isEmpty() ? 0 : LOCAL_PATH);
    }

    /// The truth where there is one, else what its localizer believes, or where its stand-in is.
    private static Optional<Pose2d> bestPose(RobotView robot) {
        return robot.truth()
                .or(() -> robot.estimate().map(e -> e.value().mapFromBase()))
                .or(() -> robot.real().flatMap(RobotView.Real::standIn));
    }

    /// What the robot's flags announce, in the order of the flags.
    private void blocks(RobotView robot) {
        if (bestPose(robot).isEmpty()) {
            return;
        }
        estimate(robot).ifPresent(this::estimate);
        robot.goal().ifPresent(goal -> {
            reserve(12);
            pose(goal);
            out.putShort((short) 0);
        });
        path(robot.path());
        robot.scan().map(Stamped::value).ifPresent(this::scan);
        robot.ranges().map(Stamped::value).ifPresent(this::ranges);
        robot.particles().map(Stamped::value).ifPresent(this::particles);
        robot.gripper().map(Stamped::value).ifPresent(this::gripper);
        mapFromOdom(robot).ifPresent(odom -> {
            reserve(12);
            pose(odom);
            out.putShort((short) 0);
        });
        elsewhere(elsewhere(robot));
        short sideways = sideways(robot);
        if (sideways != 0) {
            reserve(4);
            out.putShort(sideways).putShort((short) 0);
        }
        path(robot.localPath());
    }

    /// To the left [mm/s]; only omnidirectional bases have such a speed.
    private static short sideways(RobotView robot) {
        return milli(robot.odometry().map(o -> o.value().velocity().vy()).orElse(0.0));
    }

    /// Where its localizer has the frame of odometry on the map (REP 105), or its best pose where nothing localizes it.
    /// Nothing when the localizer has fallen silent: the frame would seem to drive along.
    private static Optional<Pose2d> mapFromOdom(RobotView robot) {
        return robot.odometry()
                .flatMap(odometry -> baseThen(robot, odometry.time())
                        .map(mapFromBase -> mapFromBase.compose(
                                odometry.value().odomFromBase().inverse())))
                .filter(Pose2d::isFinite);
    }

    private static Optional<Pose2d> baseThen(RobotView robot, Instant time) {
        return estimate(robot).isEmpty()
                ? bestPose(robot)
                : robot.estimate()
                        .filter(estimate ->
                                Duration.between(estimate.time(), time).abs().compareTo(SAME_TIME) <= 0)
                        .map(estimate -> estimate.value().mapFromBase());
    }

    /// In the world; one on a map of the robot's own, which lies nobody knows how, is none. Where there is no world but
    /// what robots tell, it is all that there is.
    private static Optional<PoseEstimate> estimate(RobotView robot) {
        return robot.estimate()
                .filter(estimate ->
                        estimate.frame().equals("map") || robot.truth().isEmpty())
                .map(Stamped::value);
    }

    private void estimate(PoseEstimate estimate) {
        reserve(24);
        Covariance2d covariance = estimate.covariance();
        pose(estimate.mapFromBase());
        out.putShort(milli(Math.sqrt(Math.max(0, covariance.thetaTheta()))));
        out.putFloat((float) covariance.xx());
        out.putFloat((float) covariance.xy());
        out.putFloat((float) covariance.yy());
    }

    /// Where else than at its estimate a robot may be.
    private static List<Hypothesis> elsewhere(RobotView robot) {
        List<Hypothesis> all = estimate(robot).map(PoseEstimate::hypotheses).orElse(List.of());
        return all.size() < 2 ? List.of() : all.subList(1, Math.min(all.size(), 1 + MAX_ELSEWHERE)); // the first is it
    }

    private void elsewhere(List<Hypothesis> hypotheses) {
        if (hypotheses.isEmpty()) {
            return;
        }
        reserve(4 + 24 * hypotheses.size());
        out.putInt(hypotheses.size());
        for (Hypothesis one : hypotheses) {
            pose(one.mapFromBase());
            out.putShort((short) Math.round(0xffff * Math.clamp(one.weight(), 0, 1)));
            out.putFloat((float) one.covariance().xx());
            out.putFloat((float) one.covariance().xy());
            out.putFloat((float) one.covariance().yy());
        }
    }

    private void path(Path2d path) {
        if (path.points().isEmpty()) {
            return;
        }
        reserve(4 + 8 * path.points().size());
        out.putInt(path.points().size());
        for (Point2d point : path.points()) {
            out.putInt(millimetres(point.x()));
            out.putInt(millimetres(point.y()));
        }
    }

    private void scan(LaserScan scan) {
        reserve(32 + 2 * scan.count() + 2);
        double unit = rangeUnit(scan.rangeMax());
        pose(scan.baseFromLaser());
        out.putShort((short) 0);
        out.putFloat((float) scan.angleMin());
        out.putFloat((float) scan.angleIncrement());
        out.putFloat((float) scan.rangeMax());
        out.putFloat((float) unit);
        out.putInt(scan.count());
        for (float range : scan.ranges()) {
            out.putShort(range(range, unit));
        }
        pad();
    }

    private void ranges(RangeArray array) {
        reserve(16 + 12 * array.count());
        double unit = rangeUnit(array.rangeMax());
        out.putFloat((float) array.fieldOfView());
        out.putFloat((float) array.rangeMax());
        out.putFloat((float) unit);
        out.putInt(array.count());
        for (int i = 0; i < array.count(); i++) {
            pose(array.baseFromSensors().get(i));
            out.putShort(range(array.ranges()[i], unit));
        }
    }

    private void particles(ParticleCloud cloud) {
        int stride = (cloud.count() + MAX_PARTICLES - 1) / MAX_PARTICLES;
        int count = stride == 0 ? 0 : (cloud.count() + stride - 1) / stride;
        float[] poses = cloud.poses();
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        float maxWeight = 0;
        for (int i = 0; i < cloud.count(); i += stride) {
            minX = Math.min(minX, poses[3 * i]);
            maxX = Math.max(maxX, poses[3 * i]);
            minY = Math.min(minY, poses[3 * i + 1]);
            maxY = Math.max(maxY, poses[3 * i + 1]);
            maxWeight = Math.max(maxWeight, cloud.weights()[i]);
        }
        float unit = Math.max(0.001f, Math.max(maxX - minX, maxY - minY) / 0xffff);
        reserve(16 + 8 * count);
        out.putFloat(minX);
        out.putFloat(minY);
        out.putFloat(unit);
        out.putInt(count);
        for (int i = 0; i < cloud.count(); i += stride) {
            out.putShort((short) Math.round((poses[3 * i] - minX) / unit));
            out.putShort((short) Math.round((poses[3 * i + 1] - minY) / unit));
            out.putShort(turn(poses[3 * i + 2]));
            out.putShort((short) Math.round(0xffff * (cloud.weights()[i] / maxWeight)));
        }
    }

    private void gripper(GripperState gripper) {
        reserve(4);
        double closed = gripper.closed() >= 0 ? Math.min(1, gripper.closed()) : 0; // open when it can't tell
        out.putShort((short) Math.round(0xffff * closed));
        double raised = gripper.raised() >= 0 ? Math.min(1, gripper.raised()) : 0; // down when it can't tell
        out.putShort((short) (Math.round(0x7fff * raised) << 1 | (gripper.holding() ? HOLDING : 0)));
    }

    /// 10 bytes.
    private void pose(Pose2d pose) {
        out.putInt(millimetres(pose.x()));
        out.putInt(millimetres(pose.y()));
        out.putShort(turn(pose.theta()));
    }

    private static short turn(double angle) {
        return (short) Math.round(Angles.wrap(angle) / TURN * 0x10000);
    }

    private static int millimetres(double meters) {
        return Math.clamp(Math.round(meters * 1000), Integer.MIN_VALUE, Integer.MAX_VALUE);
    }

    private static short milli(double value) {
        return (short) Math.clamp(Math.round(value * 1000), Short.MIN_VALUE, Short.MAX_VALUE);
    }

    /// Millimetres where they reach far enough.
    private static double rangeUnit(double rangeMax) {
        return Math.max(0.001, rangeMax / MAX_RANGE);
    }

    private static short range(float range, double unit) {
        if (Float.isNaN(range)) {
            return (short) BROKEN;
        }
        if (range == Float.POSITIVE_INFINITY) {
            return (short) NOTHING;
        }
        return (short) Math.clamp(Math.round(range / unit), TOO_CLOSE, MAX_RANGE);
    }

    private void pad() {
        while (out.position() % 4 != 0) {
            out.put((byte) 0);
        }
    }

    private void reserve(int bytes) {
        if (out.remaining() < bytes) {
            out = allocate(2 * (out.position() + bytes)).put(out.flip());
        }
    }

    private static ByteBuffer allocate(int bytes) {
        return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static double seconds(Duration time) {
        return time.toNanos() / 1e9;
    }
}
