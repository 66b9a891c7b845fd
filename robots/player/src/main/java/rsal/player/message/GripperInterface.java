package rsal.player.message;

/// Interface `gripper`: two paddles that close.
public final class GripperInterface {
    public static final int STATE = 1;

    public static final int OPEN = 1;
    public static final int CLOSE = 2;
    public static final int STOP = 3;
    public static final int STORE = 4;
    public static final int RETRIEVE = 5;

    public static final int GEOMETRY = 1;

    private GripperInterface() {}

    /// @param state 1 open, 2 closed, 3 moving, 4 error
    /// @param beams that are broken, as bits: of Stage 4 is the inner one, 8 the one near the tip
    /// @param stored how many things it has in it
    public record State(int state, int beams, int stored) {}

    /// @param pose in the robot's frame
    public record Geometry(Pose3 pose, Box3 outer, Box3 inner, int beams, int capacity) {}
}
