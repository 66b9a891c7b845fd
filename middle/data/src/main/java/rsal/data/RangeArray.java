package rsal.data;

import java.util.List;

/// One round of sonars or infrared sensors, each a cone (`sensor_msgs/Range`). Ranges [m] after REP 117 as in
/// [LaserScan].
///
/// @param baseFromSensors pose of each sensor in the base frame, looking along its x axis
/// @param fieldOfView full opening angle of each cone [rad]
/// @param rangeMin shortest range they measure [m]
/// @param rangeMax longest range they measure [m]
/// @param ranges one for each sensor [m]; handed over, not shared
public record RangeArray(
        List<Pose2d> baseFromSensors, double fieldOfView, double rangeMin, double rangeMax, float[] ranges) {

    public RangeArray {
        baseFromSensors = List.copyOf(baseFromSensors);
        if (baseFromSensors.size() != ranges.length) {
            throw new IllegalArgumentException(
                    "Each of %d sensors has a range, not %d.".formatted(baseFromSensors.size(), ranges.length));
        }
    }

    public int count() {
        return ranges.length;
    }

    /// Whether something was measured, as [Rep117#isHit] has it.
    public boolean isHit(int sensor) {
        return Rep117.isHit(ranges[sensor], rangeMin, rangeMax);
    }

    /// How far off something is, as [Rep117#distance] has it [m].
    public double distance(int sensor) {
        return Rep117.distance(ranges[sensor], rangeMin);
    }
}
