package rsal.navigation.carmen;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Parameter;
import rsal.navigation.log.LogWriter;
import rsal.navigation.log.RobotLog;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.replay.RecordedDrive.Stop;

/// Writes CARMEN's logs: `ODOM`, and scans as `ROBOTLASER1`, which has their angles and where the laser is. A scan's
/// poses are odometry; one that somebody has corrected takes their place, as in public logs that are called corrected.
///
/// Ranges of nothing are the longest range of the laser; those that were too close are 0.
final class CarmenWriter implements LogWriter {
    private static final List<String> SUFFIXES = List.of(".log", ".clf");
    private static final double LONGEST = 81.83; // m; what lasers of SICK send for nothing
    private static final String HOST = "rsal";

    @Override
    public String description() {
        return "a log of CARMEN (OUT.log)";
    }

    @Override
    public boolean accepts(String name) {
        return SUFFIXES.stream().anyMatch(name.toLowerCase(Locale.ROOT)::endsWith);
    }

    @Override
    public Written write(RobotLog log, Path target, boolean force) throws IOException {
        RecordedDrive drive = RecordedDrive.of(log);
        OpenOption how = force ? StandardOpenOption.CREATE : StandardOpenOption.CREATE_NEW;
        try (Writer out = Files.newBufferedWriter(
                target, StandardCharsets.UTF_8, how, StandardOpenOption.WRITE, StandardOpenOption.TRUNCATE_EXISTING)) {
            out.write("# CARMEN Logfile\n# written by rsal convert\n");
            for (Parameter parameter : log.parameters()) {
                out.write("PARAM %s %s\n".formatted(parameter.name(), parameter.value()));
            }
            write(log.motions(), drive.stops(), out);
        }
        return new Written(drive.stops().size(), log.motions().size(), drive.omitted());
    }

    /// By time; odometry first.
    private static void write(List<Motion> motions, List<Stop> stops, Writer out) throws IOException {
        Instant start = start(motions, stops);
        int next = 0;
        for (Stop stop : stops) {
            while (next < motions.size() && !motions.get(next).time().isAfter(stop.time())) {
                out.write(line(motions.get(next++), start));
            }
            out.write(line(stop, start));
        }
        for (Motion motion : motions.subList(next, motions.size())) {
            out.write(line(motion, start));
        }
    }

    private static Instant start(List<Motion> motions, List<Stop> stops) {
        Instant motion = motions.isEmpty() ? Instant.MAX : motions.getFirst().time();
        Instant stop = stops.isEmpty() ? Instant.MAX : stops.getFirst().time();
        return motion.isBefore(stop) ? motion : stop;
    }

    private static String line(Motion motion, Instant start) {
        return "ODOM %s %s %s 0 %s\n"
                .formatted(pose(motion.odomFromBase()), motion.speed(), motion.turnRate(), end(motion.time(), start));
    }

    /// `ROBOTLASER1 type startAngle fieldOfView step rangeMax accuracy remissionMode count ranges… 0 laserPose
    /// robotPose
    /// speed turnRate forwardSafety sideSafety turnAxis time host loggerTime`
    private static String line(Stop stop, Instant start) {
        LaserScan scan = stop.scan();
        double most = Double.isFinite(scan.rangeMax()) ? scan.rangeMax() : LONGEST;
        var line = new StringBuilder("ROBOTLASER1 0 %s %s %s %s 0 0 %d"
                .formatted(
                        scan.angleMin(),
                        scan.angleIncrement() * (scan.count() - 1),
                        scan.angleIncrement(),
                        most,
                        scan.count()));
        for (float range : scan.ranges()) {
            line.append(' ').append(range(range, most));
        }
        Pose2d robot = stop.mapFromBase().orElse(stop.odomFromBase());
        return line.append(" 0 %s %s 0 0 0 0 0 %s\n"
                        .formatted(pose(robot.compose(scan.baseFromLaser())), pose(robot), end(stop.time(), start)))
                .toString();
    }

    private static String range(float range, double most) {
        if (range == Float.POSITIVE_INFINITY) {
            return Double.toString(most);
        }
        return range == Float.NEGATIVE_INFINITY ? "0" : Float.toString(range).toLowerCase(Locale.ROOT);
    }

    private static String pose(Pose2d pose) {
        return "%s %s %s".formatted(pose.x(), pose.y(), pose.theta());
    }

    /// Time, host, and time since the log's start [s].
    private static String end(Instant time, Instant start) {
        double since = (time.getEpochSecond() - start.getEpochSecond()) + (time.getNano() - start.getNano()) * 1e-9;
        return "%d.%06d %s %s"
                .formatted(
                        time.getEpochSecond(), time.getNano() / 1000, HOST, String.format(Locale.ROOT, "%.6f", since));
    }
}
