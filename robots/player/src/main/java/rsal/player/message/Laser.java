package rsal.player.message;

/// Interface `laser`: a scanner.
public final class Laser {
    public static final int SCAN = 1;
    public static final int SCAN_POSE = 2;
    public static final int SCAN_ANGLES = 3;

    public static final int GEOMETRY = 1;
    public static final int SET_CONFIGURATION = 2;
    public static final int CONFIGURATION = 3;
    public static final int POWER = 4;
    public static final int IDENTITY = 5;
    public static final int FILTER = 6;

    private Laser() {}

    /// Range i lies at `minAngle` + i · `resolution`, 0 is straight ahead.
    ///
    /// @param maxRange what a range has that hit nothing [m]
    /// @param intensities 0 to 255
    public record Scan(
            float minAngle,
            float maxAngle,
            float resolution,
            float maxRange,
            float[] ranges,
            byte[] intensities,
            int id) {}

    /// @param pose where it was taken from
    public record ScanPose(Scan scan, Pose pose) {}

    /// @param angles of each range
    public record ScanAngles(float maxRange, float[] ranges, float[] angles, byte[] intensities, int id) {}

    /// @param pose in the robot's frame
    public record Geometry(Pose3 pose, Box3 size) {}

    /// @param frequency [Hz]
    public record Configuration(
            float minAngle,
            float maxAngle,
            float resolution,
            float maxRange,
            float rangeResolution,
            int intensity,
            float frequency) {}

    public record Power(int on) {}

    public record Identity(int serialNumber) {}

    /// @param type 1 median, 2 edge, 3 range, 4 mean
    public record Filter(int type, float[] parameters) {}
}
