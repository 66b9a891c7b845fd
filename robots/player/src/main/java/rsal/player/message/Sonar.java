package rsal.player.message;

import java.util.List;

/// Interface `sonar`: a ring of sonars.
public final class Sonar {
    public static final int RANGES = 1;
    public static final int GEOMETRY_DATA = 2;

    public static final int GEOMETRY = 1;
    public static final int POWER = 2;

    private Sonar() {}

    /// @param ranges one of each [m]
    public record Ranges(float[] ranges) {}

    /// @param poses of each, in the robot's frame
    public record Geometry(List<Pose3> poses) {}

    public record Power(int on) {}
}
