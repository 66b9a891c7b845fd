package rsal.navigation.carmen;

import java.io.IOException;
import java.io.InputStream;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.carmen.LineFields.Misread;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogEntry;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Parameter;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;
import rsal.navigation.log.LogLines;

/// Reads logs of CARMEN (M. Montemerlo, N. Roy, S. Thrun: Perspectives on Standardization in Mobile Robot
/// Programming: The Carnegie Mellon Navigation Toolkit, IROS 2003) as a stream of messages: `ODOM`, `FLASER`,
/// `RAWLASER1`, `ROBOTLASER1` and `PARAM`, plain or packed with gzip. Other kinds are passed over.
///
/// * **Angles.** A `FLASER` has no angles: its first reading is at half the field of view to the right. An odd
///   count of readings has one at each end (181, 361); of an even count the last is missing, as lasers of SICK are
///   recorded (180, 360).
/// * **Nothing there.** Readings from the range limit on, and what lasers of SICK send instead of a range, become
///   +∞; zeros become −∞ (too close), what is no length NaN. The last two are counted per scan. A scan in which
///   nothing was measured is skipped.
/// * **Time.** The clock is the first one that a message tells: that of the sender or, when this is 0, that of the
///   logger. A message without it has the time of the one before. What goes back in time is skipped, each kind
///   of message by itself; after [#RESTART] that go on from there, the clock has been set back and is believed.
/// * **Mount.** A laser is where the log has it beside the robot; a `FLASER` only if it was moved straight ahead,
///   as in many logs the first of its poses is not the laser's but a corrected one of the robot. Whether a laser stays
///   where it is mounted is known when all of a log was read ([rsal.navigation.log.RobotLog]). A `RAWLASER1` has no
/// poses: its laser is
///   where the parameters before it say, `robot_frontlaser_offset` (ahead of the robot's middle [m]),
///   `robot_frontlaser_side_offset` (to the left [m]) and `robot_frontlaser_angular_offset` (counter-clockwise [rad]),
///   put together as CARMEN's `robot` does; in the middle without them.
///
/// A message that does not say what its kind promises is skipped, and counted by reason; so is the last line of a
/// plain file that was cut within it. A packed file that is cut short or damaged is a [BrokenLog].
final class CarmenReader {
    static final int RESTART = 3;
    private static final List<String> SCANS = List.of("FLASER", "RAWLASER1", "ROBOTLASER1");
    private static final int MOST_READINGS = 100_000;
    private static final double FARTHEST_MOUNT = 1.5; // m
    private static final double FARTHEST = 1e6; // m, rad
    private static final double NO_OFFSET = 1e-3; // m, rad
    private static final String AHEAD = "robot_frontlaser_offset";
    private static final String LEFT = "robot_frontlaser_side_offset";
    private static final String TURNED = "robot_frontlaser_angular_offset";

    private final LogLines lines;
    private final LaserHints hints;
    private final LogCollector log;
    private final Clock clock = new Clock();
    private final Headings headings = new Headings();
    private Pose2d baseFromRawLaser = Pose2d.ORIGIN; // as the parameters read so far say

    private CarmenReader(LogLines lines, LaserHints hints, LogCollector log) {
        this.lines = lines;
        this.hints = hints;
        this.log = log;
    }

    /// @see CarmenFormat#read
    static void read(String file, InputStream in, LaserHints hints, LogCollector log) throws IOException {
        var reader = new CarmenReader(new LogLines(file, in), hints, log);
        reader.read();
        reader.headings.degrees().ifPresent(log::headingsAreProbablyDegrees);
        if (log.isEmpty()) {
            throw new BrokenLog(
                    file,
                    0,
                    "There is no message of CARMEN in it (ODOM, FLASER, RAWLASER1, ROBOTLASER1, PARAM)."
                            + " Maybe it is another kind of file.");
        }
    }

    private void read() throws IOException {
        for (var line = lines.read(); line.isPresent(); line = lines.read()) {
            var fields = new LineFields(line.get());
            if (!fields.hasNext()) {
                continue;
            }
            try {
                LogEntry entry = entry(fields);
                if (entry == null) {
                    log.passOver();
                } else {
                    log.add(entry);
                }
            } catch (Misread e) {
                log.skip(
                        lines.number(),
                        lines.cutShort() ? "cut short" : e.reason(),
                        String.valueOf(e.getMessage()),
                        isScan(line.get()));
            }
        }
    }

    private static boolean isScan(String line) {
        return SCANS.stream().anyMatch(line.stripLeading()::startsWith);
    }

    private @Nullable LogEntry entry(LineFields fields) throws Misread {
        return switch (fields.word()) {
            case "ODOM" -> motion(fields);
            case "FLASER" -> plainScan(fields);
            case "RAWLASER1" -> configuredScan(fields, false);
            case "ROBOTLASER1" -> configuredScan(fields, true);
            case "PARAM" -> parameter(fields);
            default -> null;
        };
    }

    /// `PARAM name value`, often with a time and a host behind, which stay in the value: it may be a text.
    private Parameter parameter(LineFields fields) throws Misread {
        var parameter = new Parameter(lines.number(), fields.word(), fields.rest());
        Pose2d reported = baseFromRawLaser;
        switch (parameter.name()) {
            case AHEAD ->
                baseFromRawLaser = new Pose2d(mount(parameter, FARTHEST_MOUNT, "m"), reported.y(), reported.theta());
            case LEFT ->
                baseFromRawLaser = new Pose2d(reported.x(), mount(parameter, FARTHEST_MOUNT, "m"), reported.theta());
            case TURNED ->
                baseFromRawLaser = new Pose2d(reported.x(), reported.y(), mount(parameter, 2 * Math.PI, "rad"));
            default -> {}
        }
        return parameter;
    }

    private static double mount(Parameter parameter, double most, String unit) throws Misread {
        double value;
        try {
            value = new LineFields(parameter.value()).finite("value");
        } catch (Misread e) {
            throw new Misread(e.reason(), "%s: %s It is not used.".formatted(parameter.name(), e.getMessage()));
        }
        if (Math.abs(value) > most) {
            throw new Misread(
                    "an impossible mount",
                    "%s is '%s', not -%4$.1f to %4$.1f %3$s. It is not used."
                            .formatted(parameter.name(), value, unit, most));
        }
        return value;
    }

    /// `ODOM x y theta speed turnRate acceleration time host loggerTime`
    private Motion motion(LineFields fields) throws Misread {
        Pose2d pose = odometry(fields);
        double speed = fields.finite("speed");
        double turnRate = fields.finite("turn rate");
        fields.finite("acceleration");
        return new Motion(lines.number(), clock.read(fields, Clock.MOTION), pose, speed, turnRate);
    }

    /// `FLASER count readings… laserX laserY laserTheta odomX odomY odomTheta time host loggerTime`
    private Scan plainScan(LineFields fields) throws Misread {
        int count = readingCount(fields);
        var readings = readings(fields, count, hints.rangeMax());
        Pose2d mapFromLaser = pose(fields);
        Pose2d odomFromBase = odometry(fields);
        Pose2d mount = odomFromBase.inverse().compose(mapFromLaser);
        boolean ahead = Math.abs(mount.x()) <= FARTHEST_MOUNT
                && Math.abs(mount.y()) < NO_OFFSET
                && Math.abs(mount.theta()) < NO_OFFSET;
        Pose2d baseFromLaser = ahead && Math.abs(mount.x()) >= NO_OFFSET ? new Pose2d(mount.x(), 0, 0) : Pose2d.ORIGIN;
        Instant time = clock.read(fields, Clock.SCAN);
        double step = count == 1 ? 0 : hints.fieldOfView() / (count % 2 == 0 ? count : count - 1);
        return scan(
                time,
                new LaserScan(baseFromLaser, -hints.fieldOfView() / 2, step, 0, hints.rangeMax(), readings.meters()),
                new Poses.Reported(odomFromBase, ahead ? odomFromBase : mapFromLaser),
                readings);
    }

    /// `RAWLASER1 type startAngle fieldOfView step rangeMax accuracy remissionMode count readings… count
    /// remissions…`, for `ROBOTLASER1` also `laserX laserY laserTheta robotX robotY robotTheta speed turnRate
    /// forwardSafety sideSafety turnAxis`, then `time host loggerTime`.
    private Scan configuredScan(LineFields fields, boolean posed) throws Misread {
        fields.skip(1);
        double start = fields.finite("first angle");
        double fieldOfView = fields.finite("field of view");
        double step = fields.finite("angle between readings");
        double rangeMax = fields.finite("longest range");
        fields.skip(2);
        int count = readingCount(fields);
        if (step == 0 && count > 1) { // some drivers omit it
            step = fieldOfView / (count - 1);
        }
        if (!(rangeMax > 0)
                || Math.abs(start) > 2 * Math.PI
                || !(Math.abs(step) * (count - 1) <= 2 * Math.PI + Math.abs(step))) {
            throw new Misread(
                    "an impossible laser",
                    "Its first angle is '%s', the angle between readings '%s', its longest range '%s'."
                            .formatted(start, step, rangeMax));
        }
        double limit = Math.min(rangeMax, hints.rangeMax());
        var readings = readings(fields, count, limit);
        fields.skip(fields.count("remissions", MOST_READINGS));
        Pose2d baseFromLaser = baseFromRawLaser;
        Poses poses = new Poses.Unknown();
        if (posed) {
            Pose2d odomFromLaser = pose(fields);
            Pose2d odomFromBase = odometry(fields);
            fields.skip(5);
            Pose2d mount = odomFromBase.inverse().compose(odomFromLaser);
            boolean near = Math.hypot(mount.x(), mount.y()) <= FARTHEST_MOUNT;
            baseFromLaser = near ? mount : Pose2d.ORIGIN;
            poses = new Poses.Reported(odomFromBase, near ? odomFromBase : odomFromLaser);
        }
        Instant time = clock.read(fields, Clock.SCAN);
        return scan(time, new LaserScan(baseFromLaser, start, step, 0, limit, readings.meters()), poses, readings);
    }

    private Scan scan(Instant time, LaserScan scan, Poses poses, Readings readings) throws Misread {
        if (readings.broken() == scan.count()) {
            throw new Misread("nothing measured", "None of its %d readings is a range.".formatted(scan.count()));
        }
        return new Scan(lines.number(), time, scan, poses, readings.broken());
    }

    private static int readingCount(LineFields fields) throws Misread {
        int count = fields.count("readings", MOST_READINGS);
        if (count == 0) {
            throw new Misread("no readings", "It has no readings.");
        }
        return count;
    }

    private record Readings(float[] meters, int broken) {}

    private static Readings readings(LineFields fields, int count, double rangeMax) throws Misread {
        var meters = new float[count];
        int broken = 0;
        for (int i = 0; i < count; i++) {
            float read = (float) fields.number();
            if (Float.isNaN(read) || read < 0) {
                meters[i] = Float.NaN;
                broken++;
            } else if (read == 0) {
                meters[i] = Float.NEGATIVE_INFINITY;
                broken++;
            } else {
                meters[i] = read >= rangeMax || isCode(read) ? Float.POSITIVE_INFINITY : read;
            }
        }
        return new Readings(meters, broken);
    }

    /// What lasers of SICK send instead of a range: the highest numbers of 13 and 15 bits, here of millimeters. Those
    /// of centimeters are farther than anything seen. (SICK: Telegrams for Configuring and Operating the LMS 2xx,
    /// on measured values beyond the range.)
    private static boolean isCode(float range) {
        long millimeters = Math.round(range * 1000.0);
        boolean of15Bits = millimeters >= 32_759 && millimeters <= 32_767;
        boolean of13Bits = millimeters >= 8183 && millimeters <= 8191 && millimeters % 10 != 0;
        return of15Bits || of13Bits;
    }

    private Pose2d odometry(LineFields fields) throws Misread {
        RawPose raw = rawPose(fields);
        headings.add(raw.theta());
        return raw.pose();
    }

    private static Pose2d pose(LineFields fields) throws Misread {
        return rawPose(fields).pose();
    }

    /// @param theta as it stands there, in whatever unit
    private record RawPose(double x, double y, double theta) {
        Pose2d pose() {
            return new Pose2d(x, y, theta);
        }
    }

    private static RawPose rawPose(LineFields fields) throws Misread {
        double x = fields.finite("pose's x");
        double y = fields.finite("pose's y");
        double theta = fields.finite("pose's heading");
        if (!(Math.max(Math.abs(x), Math.abs(y)) <= FARTHEST && Math.abs(theta) <= FARTHEST)) {
            throw new Misread("an impossible pose", "It is at (%s, %s, %s).".formatted(x, y, theta));
        }
        return new RawPose(x, y, theta);
    }
}
