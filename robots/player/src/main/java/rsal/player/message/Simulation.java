package rsal.player.message;

/// Interface `simulation`: where all really is. Names are [Chars].
public final class Simulation {
    public static final int PAUSE = 1;
    public static final int RESET = 2;
    public static final int SAVE = 3;

    public static final int POSE = 1;
    public static final int SET_POSE = 2;
    public static final int POSE3 = 3;
    public static final int SET_POSE3 = 4;
    public static final int PROPERTY = 5;
    public static final int SET_PROPERTY = 6;

    private Simulation() {}

    /// @param pose in the frame of what it stands on
    public record Placed(byte[] name, Pose pose) {}

    /// @param time of the simulation; of Stage [µs]
    public record Placed3(byte[] name, Pose3 pose, double time) {}

    public record Property(byte[] name, byte[] property, int index, byte[] value) {}
}
