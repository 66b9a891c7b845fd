package rsal.player.message;

import java.util.List;

/// Interface `bumper`.
public final class BumperInterface {
    public static final int STATE = 1;
    public static final int GEOMETRY_DATA = 2;

    public static final int GEOMETRY = 1;

    private BumperInterface() {}

    /// @param pressed one byte of each; other than 0 when it is
    public record State(byte[] pressed) {}

    /// @param radius of its curve; 0 when it is straight
    public record Segment(Pose3 pose, float length, float radius) {}

    public record Geometry(List<Segment> bumpers) {}
}
