package rsal.ros2.message;

import java.util.Arrays;
import java.util.Optional;

/// Why the planner of Nav2 has no path, by the error codes of `nav2_msgs/ComputePathToPose`, which are the same from
/// Jazzy on. Humble has none.
public enum PlanningError {
    UNKNOWN(200, "The robot's planner failed."),
    INVALID_PLANNER(201, "The robot has no such planner."),
    TF_ERROR(202, "The robot's planner does not know where the start or the goal is on the map."),
    START_OUTSIDE_MAP(203, "The start is outside of the map."),
    GOAL_OUTSIDE_MAP(204, "The goal is outside of the map."),
    START_OCCUPIED(205, "The start is occupied."),
    GOAL_OCCUPIED(206, "The goal is occupied."),
    TIMEOUT(207, "The robot's planner found no path in time."),
    NO_VALID_PATH(208, "No path leads to the goal.");

    private final int code;
    private final String words;

    PlanningError(int code, String words) {
        this.code = code;
        this.words = words;
    }

    public int code() {
        return code;
    }

    /// For people.
    public String words() {
        return words;
    }

    /// Empty when Nav2 has no error of planning with this code.
    public static Optional<PlanningError> of(long code) {
        return Arrays.stream(values()).filter(each -> each.code == code).findFirst();
    }
}
