package rsal.navigation.log;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import rsal.data.Angles;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;

/// A whole log in memory: at most [#MOST_READINGS] readings.
///
/// @param scans in the order of the file, times never going back but where the clock was
/// @param motions the same
/// @param skipped what was not used
/// @param rangeMax from here on readings hit nothing [m], as the log itself shows it or the reader was told
/// @param wandering how far the poses that the log tells of the laser move about on the robot, where they do: then they
/// were taken for poses of the robot that somebody has corrected, and the laser for mounted in its middle
/// @param degrees the largest heading of odometry when headings are degrees, by how they change; they were read as
/// radians, as CARMEN writes them
/// @param topic that the scans are of; empty for logs without topics
public record RobotLog(
        List<Scan> scans,
        List<Motion> motions,
        List<LogEntry.Parameter> parameters,
        Skipped skipped,
        double rangeMax,
        Optional<Wandering> wandering,
        OptionalDouble degrees,
        Optional<ScanTopic> topic) {
    /// 400 MB of ranges; the longest public logs have a tenth of this.
    public static final int MOST_READINGS = 100_000_000;

    private static final double SAME = 0.1; // m; codes for nothing differ by less
    private static final double SHARE_OF_CODES = 2e-3; // of all readings
    private static final double BELOW = 0.5; // m; so far below codes there are fewer readings than codes

    private static final int MANY_SCANS = 5;
    private static final double MOUNT_METERS = 0.05; // a laser that is screwed on doesn't move so far
    private static final double MOUNT_RADIANS = 0.05;
    private static final double FEW_MOUNTS = 0.1; // share of scans whose poses may be at odds

    /// How far a laser moves on its robot, as a log has it.
    ///
    /// @param meters at most, from where it is for most
    /// @param radians the same
    public record Wandering(double meters, double radians) {}

    /// Where the scans of a log with topics come from.
    ///
    /// @param others topics with scans that were not read, in the order of their names
    public record ScanTopic(String name, List<String> others) {
        public ScanTopic {
            others = List.copyOf(others);
        }
    }

    public RobotLog {
        scans = List.copyOf(scans);
        motions = List.copyOf(motions);
        parameters = List.copyOf(parameters);
    }

    /// @param rangeMax ranges from here on hit nothing, as the reader was told [m]
    /// @param degrees as in the log
    static RobotLog of(
            List<Scan> read,
            List<Motion> motions,
            List<LogEntry.Parameter> parameters,
            Skipped skipped,
            double rangeMax,
            OptionalDouble degrees,
            Optional<ScanTopic> topic) {
        double longest = Math.min(rangeMax, longest(read));
        Optional<Wandering> wandering = wandering(read);
        List<Scan> scans = read.stream()
                .map(scan -> longest < rangeMax ? limited(scan, longest) : scan)
                .map(scan -> wandering.isPresent() ? inTheMiddle(scan) : scan)
                .toList();
        return new RobotLog(scans, motions, parameters, skipped, longest, wandering, degrees, topic);
    }

    /// The time of all of its scans, when it is one and the same of many, so that it tells nothing.
    public Optional<Instant> oneTime() {
        return scans.size() < MANY_SCANS
                        || scans.stream()
                                .anyMatch(scan ->
                                        !scan.time().equals(scans.getFirst().time()))
                ? Optional.empty()
                : Optional.of(scans.getFirst().time());
    }

    /// Whether a log has its laser move on the robot: more than a few scans are not where it is for most.
    private static Optional<Wandering> wandering(List<Scan> scans) {
        List<Pose2d> mounts =
                scans.stream().flatMap(scan -> mount(scan).stream()).toList();
        if (mounts.isEmpty()) {
            return Optional.empty();
        }
        var usual = new Pose2d(
                median(mounts.stream().mapToDouble(Pose2d::x)),
                median(mounts.stream().mapToDouble(Pose2d::y)),
                median(mounts.stream().mapToDouble(Pose2d::theta)));
        long elsewhere = mounts.stream()
                .filter(mount -> !mount.isNear(usual, MOUNT_METERS, MOUNT_RADIANS))
                .count();
        return elsewhere <= FEW_MOUNTS * mounts.size()
                ? Optional.empty()
                : Optional.of(new Wandering(
                        mounts.stream()
                                .mapToDouble(mount -> mount.distanceTo(usual))
                                .max()
                                .orElseThrow(),
                        mounts.stream()
                                .mapToDouble(mount -> Math.abs(Angles.difference(mount.theta(), usual.theta())))
                                .max()
                                .orElseThrow()));
    }

    private static double median(DoubleStream values) {
        double[] sorted = values.sorted().toArray();
        return sorted[sorted.length / 2];
    }

    /// Where the log has the laser on the robot, if it tells.
    private static Optional<Pose2d> mount(Scan scan) {
        return switch (scan.poses()) {
            case Poses.Reported(Pose2d odomFromBase, Pose2d mapFromBase) ->
                Optional.of(odomFromBase
                        .inverse()
                        .compose(mapFromBase)
                        .compose(scan.scan().baseFromLaser()));
            case Poses.Unknown() -> Optional.empty();
        };
    }

    /// The same scan, of a laser in the middle of a robot that was where the log has the laser.
    private static Scan inTheMiddle(Scan scan) {
        LaserScan seen = scan.scan();
        return switch (scan.poses()) {
            case Poses.Reported(Pose2d odomFromBase, Pose2d mapFromBase) ->
                new Scan(
                        scan.line(),
                        scan.time(),
                        new LaserScan(
                                Pose2d.ORIGIN,
                                seen.angleMin(),
                                seen.angleIncrement(),
                                seen.rangeMin(),
                                seen.rangeMax(),
                                seen.ranges()),
                        new Poses.Reported(odomFromBase, mapFromBase.compose(seen.baseFromLaser())),
                        scan.broken());
            case Poses.Unknown() -> scan;
        };
    }

    /// Where the longest readings of the log lie when they are so many, so equal and so far from others that they
    /// must be what the laser says for nothing; +∞ otherwise: the far corner of a room has walls that lead to it.
    /// Drivers write 8.0, 29.9 and more.
    private static double longest(List<Scan> scans) {
        float most = 0;
        long readings = 0;
        for (Scan scan : scans) {
            readings += scan.scan().count();
            for (float range : scan.scan().ranges()) {
                most = range < Float.POSITIVE_INFINITY ? Math.max(most, range) : most;
            }
        }
        long codes = 0;
        long below = 0;
        for (Scan scan : scans) {
            for (float range : scan.scan().ranges()) {
                codes += range >= most - SAME && range <= most ? 1 : 0;
                below += range >= most - SAME - BELOW && range < most - SAME ? 1 : 0;
            }
        }
        return codes > 100 && codes > SHARE_OF_CODES * readings && codes > 2 * below
                ? most - SAME
                : Double.POSITIVE_INFINITY;
    }

    private static Scan limited(Scan entry, double rangeMax) {
        LaserScan scan = entry.scan();
        var ranges = scan.ranges().clone();
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = ranges[i] >= rangeMax ? Float.POSITIVE_INFINITY : ranges[i];
        }
        return new Scan(
                entry.line(),
                entry.time(),
                new LaserScan(
                        scan.baseFromLaser(),
                        scan.angleMin(),
                        scan.angleIncrement(),
                        scan.rangeMin(),
                        Math.min(scan.rangeMax(), rangeMax),
                        ranges),
                entry.poses(),
                entry.broken());
    }
}
