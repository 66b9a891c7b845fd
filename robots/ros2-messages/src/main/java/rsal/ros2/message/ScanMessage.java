package rsal.ros2.message;

import rsal.data.LaserScan;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.RosMessage;

/// What is said in a `sensor_msgs/LaserScan`. Handed over, not copied: a scan that is made of it has its ranges.
///
/// @param stamp when it was measured [ns] since 1970, or of a simulated time
/// @param frame of the laser
/// @param angleMin direction of the first beam in that frame [rad]
/// @param angleIncrement angle from a beam to the next one [rad]; negative where the laser sweeps clockwise
/// @param ranges as they came [m]: not limited to what the laser measures
public record ScanMessage(
        long stamp,
        String frame,
        double angleMin,
        double angleIncrement,
        double rangeMin,
        double rangeMax,
        float[] ranges) {
    private static final double ROUND = 2 * Math.PI + 0.1; // rad; a whole turn, with an overlap

    public static ScanMessage of(RosMessage message) {
        RosMessage header = message.message("header");
        return new ScanMessage(
                RosMessages.stamp(header),
                header.text("frame_id"),
                message.number("angle_min"),
                message.number("angle_increment"),
                message.number("range_min"),
                message.number("range_max"),
                message.get("ranges", float[].class));
    }

    /// The same from its bytes, without anything in between, as scans come often.
    ///
    /// @param frame that it probably has, so that no other text is made
    public static ScanMessage read(CdrReader bytes, String frame) throws InvalidCdr {
        long stamp = RosMessages.stamp(bytes);
        String its = bytes.text(frame);
        double angleMin = bytes.float32();
        bytes.float32(); // the last angle, which follows from the others
        double increment = bytes.float32();
        bytes.float32(); // time between beams
        bytes.float32(); // time between scans
        double rangeMin = bytes.float32();
        double rangeMax = bytes.float32();
        float[] ranges = bytes.float32s(bytes.count(Float.BYTES));
        return new ScanMessage(stamp, its, angleMin, increment, rangeMin, rangeMax, ranges);
    }

    /// Whether there is such a laser: with beams of at most a whole turn.
    public boolean isPossible() {
        return ranges.length > 0
                && Double.isFinite(angleMin + angleIncrement)
                && Math.abs(angleIncrement) * (ranges.length - 1) <= ROUND;
    }

    /// How many ranges are none: NaN, or below 0.
    public int broken() {
        int broken = 0;
        for (float range : ranges) {
            if (isBroken(range)) {
                broken++;
            }
        }
        return broken;
    }

    private static boolean isBroken(float range) {
        return Float.isNaN(range) || (range <= 0 && range != Float.NEGATIVE_INFINITY);
    }

    /// As ours are: counter-clockwise, also of a laser that is upside down, with ranges after REP 117.
    ///
    /// @param baseFromLaser where the laser is
    /// @param limit a range from which on nothing was seen, where that is less than the laser says [m]
    public LaserScan scan(FrameTransform baseFromLaser, double limit) {
        double most = Math.min(rangeMax, limit);
        limit(ranges, (float) rangeMin, (float) most);
        if (angleIncrement < 0) {
            reverse(ranges);
        }
        var scan = new LaserScan(
                baseFromLaser.planar(),
                Math.min(angleMin, angleMin + (ranges.length - 1) * angleIncrement),
                Math.abs(angleIncrement),
                rangeMin,
                most,
                ranges);
        return baseFromLaser.isUpsideDown() ? scan.mirrored() : scan;
    }

    private static void limit(float[] ranges, float least, float most) {
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = limited(ranges[i], least, most);
        }
    }

    /// A range as REP 117 has it: −∞ too close, +∞ nothing there, NaN broken.
    ///
    /// @param least from which on the sensor measures [m]
    /// @param most up to which [m]
    public static float limited(float range, float least, float most) {
        if (isBroken(range)) {
            return Float.NaN;
        }
        return range < least ? Float.NEGATIVE_INFINITY : range >= most ? Float.POSITIVE_INFINITY : range;
    }

    private static void reverse(float[] ranges) {
        for (int i = 0, k = ranges.length - 1; i < k; i++, k--) {
            float range = ranges[i];
            ranges[i] = ranges[k];
            ranges[k] = range;
        }
    }
}
