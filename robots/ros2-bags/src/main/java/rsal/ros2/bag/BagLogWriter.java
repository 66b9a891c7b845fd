package rsal.ros2.bag;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.LongSupplier;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;
import rsal.navigation.log.LogWriter;
import rsal.navigation.log.RobotLog;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.ros2.record.BagWriter;
import rsal.ros2.record.OfferedQuality;

/// Writes a robot's log as a bag, with the topics and frames of REP 105: `/scan`, `/odom`, and `/tf` from `odom` to
/// `base_link`; where somebody has corrected the poses, also from `map` to `odom`.
final class BagLogWriter implements LogWriter {
    private static final String PROGRAM = "rsal convert";
    private static final String MAP = "map";
    private static final String ODOM = "odom";
    private static final String BASE = "base_link";
    private static final String LASER = "laser";
    private static final String TRANSFORMS = "tf2_msgs/msg/TFMessage";
    private static final double STILL = 1e-3; // m, rad; lasers that move less are mounted there

    @Override
    public String description() {
        return "a bag of ROS 2 (FOLDER/, or OUT.mcap)";
    }

    @Override
    public boolean accepts(String name) {
        return isFile(name) || (name.endsWith("/") && !isFile(name.substring(0, name.length() - 1)));
    }

    private static boolean isFile(String name) {
        return name.toLowerCase(Locale.ROOT).endsWith(BagFiles.MCAP);
    }

    @Override
    public Written write(RobotLog log, Path target, boolean force) throws IOException {
        List<Motion> motions = odometry(log);
        Instant[] now = {Instant.EPOCH};
        LongSupplier clock = () -> nanos(now[0]);
        try (BagWriter bag = isFile(target.toString())
                ? BagWriter.file(target, force, PROGRAM, clock)
                : BagWriter.folder(target, force, PROGRAM, clock)) {
            var topics = new Topics(bag);
            int next = 0;
            for (Scan scan : log.scans()) {
                while (next < motions.size() && !motions.get(next).time().isAfter(scan.time())) {
                    now[0] = motions.get(next).time();
                    topics.write(motions.get(next++));
                }
                now[0] = scan.time();
                topics.write(scan);
            }
            for (Motion motion : motions.subList(next, motions.size())) {
                now[0] = motion.time();
                topics.write(motion);
            }
        }
        return new Written(log.scans().size(), motions.size(), 0);
    }

    /// That of the scans, where they have it; else the log's messages of odometry. Both at once would be told twice,
    /// and in corrected logs they are not the same.
    private static List<Motion> odometry(RobotLog log) {
        var motions = new ArrayList<Motion>();
        int next = 0;
        for (Scan scan : log.scans()) {
            if (scan.poses() instanceof Poses.Reported(Pose2d odomFromBase, Pose2d _)) {
                while (next + 1 < log.motions().size()
                        && !log.motions().get(next + 1).time().isAfter(scan.time())) {
                    next++;
                }
                Optional<Motion> near =
                        next < log.motions().size() ? Optional.of(log.motions().get(next)) : Optional.empty();
                Optional<Motion> before = motions.isEmpty() ? Optional.empty() : Optional.of(motions.getLast());
                Twist2d twist = near.map(motion -> Twist2d.drive(motion.speed(), motion.turnRate()))
                        .or(() -> before.map(last -> between(last, scan.time(), odomFromBase)))
                        .orElse(Twist2d.drive(0, 0));
                motions.add(new Motion(scan.line(), scan.time(), odomFromBase, twist.vx(), twist.omega()));
            }
        }
        return motions.isEmpty() ? log.motions() : motions;
    }

    /// How fast it was on average since a pose before, ahead and around.
    private static Twist2d between(Motion before, Instant time, Pose2d odomFromBase) {
        double seconds = Duration.between(before.time(), time).toNanos() / 1e9;
        Pose2d moved = before.odomFromBase().inverse().compose(odomFromBase);
        return seconds > 0 ? Twist2d.drive(moved.x() / seconds, moved.theta() / seconds) : Twist2d.drive(0, 0);
    }

    private static long nanos(Instant time) {
        return Duration.between(Instant.EPOCH, time).toNanos();
    }

    /// The topics of one bag.
    private static final class Topics {
        private final RosMessages messages = new RosMessages();
        private final BagWriter bag;
        private final int odometry;
        private final int scans;
        private final int transforms;
        private final int fixed;
        private Optional<Pose2d> mount = Optional.empty();

        Topics(BagWriter bag) throws IOException {
            this.bag = bag;
            odometry = bag.topic("/odom", "nav_msgs/msg/Odometry", OfferedQuality.RELIABLE);
            scans = bag.topic("/scan", "sensor_msgs/msg/LaserScan", OfferedQuality.RELIABLE);
            transforms = bag.topic("/tf", TRANSFORMS, OfferedQuality.RELIABLE);
            fixed = bag.topic("/tf_static", TRANSFORMS, OfferedQuality.LATCHED);
        }

        void write(Motion motion) throws IOException {
            var value = new Odometry(motion.odomFromBase(), new Twist2d(motion.speed(), 0, motion.turnRate()), false);
            bag.message(odometry, nanos(motion.time()), messages.odometry(motion.time(), value, ODOM, BASE));
            transform(transforms, motion.time(), ODOM, BASE, motion.odomFromBase());
        }

        void write(Scan scan) throws IOException {
            Instant time = scan.time();
            Pose2d baseFromLaser = scan.scan().baseFromLaser();
            if (mount.isEmpty() || !mount.get().isNear(baseFromLaser, STILL, STILL)) {
                mount = Optional.of(baseFromLaser);
                transform(fixed, time, BASE, LASER, baseFromLaser);
            }
            if (scan.poses() instanceof Poses.Reported(Pose2d odomFromBase, Pose2d mapFromBase)
                    && !odomFromBase.equals(mapFromBase)) {
                transform(transforms, time, MAP, ODOM, mapFromBase.compose(odomFromBase.inverse()));
            }
            bag.message(scans, nanos(time), messages.scan(time, scan.scan(), LASER, 0));
        }

        private void transform(int topic, Instant time, String parent, String child, Pose2d pose) throws IOException {
            bag.message(
                    topic,
                    nanos(time),
                    messages.transforms(List.of(new Transform(time, parent, child, FrameTransform.of(pose)))));
        }
    }
}
