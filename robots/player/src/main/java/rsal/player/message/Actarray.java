package rsal.player.message;

import java.util.List;

/// Interface `actarray`: joints in a row, as a lift or an arm [m or rad].
public final class Actarray {
    public static final int STATE = 1;

    public static final int POSITION = 1;
    public static final int POSITIONS = 2;
    public static final int SPEED = 3;
    public static final int SPEEDS = 4;
    public static final int HOME = 5;
    public static final int CURRENT = 6;
    public static final int CURRENTS = 7;

    public static final int POWER = 1;
    public static final int BRAKES = 2;
    public static final int GEOMETRY = 3;
    public static final int SET_SPEED = 4;
    public static final int SET_ACCELERATION = 5;

    /// [Joint#state]
    public static final int IDLE = 1;

    public static final int MOVING = 2;
    public static final int BRAKED = 4;
    public static final int STALLED = 8;

    private Actarray() {}

    public record Joint(float position, float speed, float acceleration, float current, int state) {}

    public record State(List<Joint> joints, int motors) {}

    public record Position(int joint, float position) {}

    public record Positions(float[] positions) {}

    /// Of a command, and of a request to set the speed of positions.
    public record Speed(int joint, float speed) {}

    public record Speeds(float[] speeds) {}

    /// @param joint −1 for all
    public record Home(int joint) {}

    public record Current(int joint, float current) {}

    public record Currents(float[] currents) {}

    public record Power(int on) {}

    public record Brakes(int on) {}

    /// @param type 1 linear, 2 rotary
    public record JointGeometry(
            int type,
            float length,
            Orientation orientation,
            Point3 axis,
            float min,
            float middle,
            float max,
            float home,
            float speed,
            int hasBrakes) {}

    public record Geometry(List<JointGeometry> joints, Point3 base, Orientation orientation) {}

    public record Acceleration(int joint, float acceleration) {}
}
