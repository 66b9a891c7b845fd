package rsal.player.message;

import java.util.List;

/// Interface `planner`: ways over a map.
public final class PlannerInterface {
    public static final int STATE = 1;

    public static final int GOAL = 1;
    public static final int START = 2;

    public static final int WAYPOINTS = 1;
    public static final int ENABLE = 2;

    private PlannerInterface() {}

    /// @param valid 1: it has found a way
    /// @param done 1: it is there
    /// @param waypoint it is on its way to
    /// @param waypointIndex which of them; −1 without a goal
    /// @param waypoints how many there are
    public record State(
            int valid, int done, Pose mapFromBase, Pose mapFromGoal, Pose waypoint, int waypointIndex, int waypoints) {}

    /// Of a goal, and of a start.
    public record Place(Pose mapFromPlace) {}

    /// @param distance of the whole way [m]
    public record Waypoints(double distance, List<Pose> waypoints) {}

    public record Enable(int on) {}
}
