package rsal.player.message;

import java.util.List;

/// Interface `fiducial`: markers.
public final class Fiducial {
    public static final int SCAN = 1;

    public static final int GEOMETRY = 1;
    public static final int VIEW = 2;
    public static final int SET_VIEW = 3;
    public static final int IDENTITY = 7;
    public static final int SET_IDENTITY = 8;

    private Fiducial() {}

    /// @param id −1, and 0 of Stage, when it can't be read
    /// @param pose as the sensor sees it
    /// @param uncertainty of the pose
    public record Marker(int id, Pose3 pose, Pose3 uncertainty) {}

    public record Markers(List<Marker> markers) {}

    /// @param pose of the sensor, in the robot's frame
    public record Geometry(Pose3 pose, Box3 size, Box2 marker) {}

    /// @param angle of its whole view
    public record View(float minRange, float maxRange, float angle) {}

    /// What others see of the robot itself.
    public record Identity(int id) {}
}
