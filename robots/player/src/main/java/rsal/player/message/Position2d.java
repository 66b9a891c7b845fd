package rsal.player.message;

/// Interface `position2d`: a base that drives.
public final class Position2d {
    public static final int STATE = 1;
    public static final int GEOMETRY_DATA = 2;

    public static final int VELOCITY = 1;
    public static final int GOAL = 2;
    public static final int CAR = 3;
    public static final int VELOCITY_HEADING = 4;

    public static final int GEOMETRY = 1;
    public static final int MOTORS = 2;
    public static final int VELOCITY_MODE = 3;
    public static final int POSITION_MODE = 4;
    public static final int SET_ODOMETRY = 5;
    public static final int RESET_ODOMETRY = 6;
    public static final int SPEED_GAINS = 7;
    public static final int POSITION_GAINS = 8;
    public static final int SPEED_PROFILE = 9;

    private Position2d() {}

    /// @param odomFromBase in the frame of odometry
    /// @param velocity of the robot, in its frame [m/s, rad/s]
    /// @param stall other than 0 when it is blocked
    public record State(Pose odomFromBase, Pose velocity, int stall) {}

    /// @param pose of the base, in the robot's frame
    public record Geometry(Pose3 pose, Box3 size) {}

    /// @param velocity [m/s, rad/s]
    /// @param motors 1: enabled
    public record Velocity(Pose velocity, int motors) {}

    /// Go somewhere, in the frame of odometry.
    ///
    /// @param velocity how fast; most servers don't mind [m/s, rad/s]
    public record Goal(Pose odomFromGoal, Pose velocity, int motors) {}

    /// @param velocity [m/s]
    /// @param steering [rad]
    public record Car(double velocity, double steering) {}

    /// @param velocity [m/s]
    /// @param heading to turn to [rad]
    public record VelocityHeading(double velocity, double heading) {}

    public record Motors(int on) {}

    public record VelocityMode(int value) {}

    /// @param position 0: takes velocities
    public record PositionMode(int position) {}

    public record Odometry(Pose odomFromBase) {}

    public record Gains(float proportional, float integral, float derivative) {}

    /// @param speed [m/s]
    /// @param acceleration [m/s²]
    public record SpeedProfile(float speed, float acceleration) {}
}
