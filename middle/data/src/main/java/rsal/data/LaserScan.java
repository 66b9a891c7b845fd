package rsal.data;

/// One sweep of a planar laser scanner, counter-clockwise (`sensor_msgs/LaserScan`). Beam `i` points to
/// `angleMin + i · angleIncrement` [rad] in the laser's frame. Ranges [m] after REP 117 ([Rep117]): −∞ too
/// close to measure, +∞ no echo, NaN invalid.
///
/// @param baseFromLaser pose of the scanner in the base frame
/// @param angleMin direction of the first beam, in the laser's frame [rad]
/// @param angleIncrement angle from a beam to the next one [rad]
/// @param rangeMin shortest range it measures [m]
/// @param rangeMax longest range it measures [m]
/// @param ranges one for each beam [m]; handed over, not shared
public record LaserScan(
        Pose2d baseFromLaser,
        double angleMin,
        double angleIncrement,
        double rangeMin,
        double rangeMax,
        float[] ranges) {

    public int count() {
        return ranges.length;
    }

    /// Direction of a beam in the laser's frame [rad].
    public double angle(int beam) {
        return angleMin + beam * angleIncrement;
    }

    /// Whether something was measured, as [Rep117#isHit] has it.
    public boolean isHit(int beam) {
        return Rep117.isHit(ranges[beam], rangeMin, rangeMax);
    }

    /// How far off something is, as [Rep117#distance] has it [m].
    public double distance(int beam) {
        return Rep117.distance(ranges[beam], rangeMin);
    }

    /// The same scan of a laser that is mounted upside down, so that its ranges go clockwise.
    public LaserScan mirrored() {
        var mirrored = new float[count()];
        for (int i = 0; i < mirrored.length; i++) {
            mirrored[i] = ranges[mirrored.length - 1 - i];
        }
        return new LaserScan(baseFromLaser, -angle(count() - 1), angleIncrement, rangeMin, rangeMax, mirrored);
    }
}
