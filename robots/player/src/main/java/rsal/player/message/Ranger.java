package rsal.player.message;

import java.util.List;

/// Interface `ranger`: whatever measures ranges.
public final class Ranger {
    public static final int RANGES = 1;
    public static final int RANGES_STAMPED = 2;
    public static final int INTENSITIES = 3;
    public static final int INTENSITIES_STAMPED = 4;
    public static final int GEOMETRY_DATA = 5;

    public static final int GEOMETRY = 1;
    public static final int POWER = 2;
    public static final int WITH_INTENSITIES = 3;
    public static final int SET_CONFIGURATION = 4;
    public static final int CONFIGURATION = 5;

    private Ranger() {}

    /// @param ranges [m]
    public record Ranges(double[] ranges) {}

    public record Intensities(double[] intensities) {}

    /// @param hasGeometry 0 when what follows means nothing
    /// @param hasConfiguration the same
    public record RangesStamped(
            Ranges ranges, int hasGeometry, Geometry geometry, int hasConfiguration, Configuration configuration) {}

    /// @param hasGeometry 0 when what follows means nothing
    /// @param hasConfiguration the same
    public record IntensitiesStamped(
            Intensities intensities,
            int hasGeometry,
            Geometry geometry,
            int hasConfiguration,
            Configuration configuration) {}

    /// @param poses of its elements, in its frame: one that turns has all ranges, as evenly as its configuration
    /// says; else each has one, in their order
    /// @param sizes of its elements
    public record Geometry(Pose3 pose, Box3 size, List<Pose3> poses, List<Box3> sizes) {}

    /// @param resolution between ranges [rad]; Stage tells the angle of its view by the number of ranges, though they
    /// are as far apart as that by one less
    /// @param frequency [Hz]
    public record Configuration(
            double minAngle,
            double maxAngle,
            double resolution,
            double minRange,
            double maxRange,
            double rangeResolution,
            double frequency) {}

    public record Power(int on) {}

    public record WithIntensities(int on) {}
}
