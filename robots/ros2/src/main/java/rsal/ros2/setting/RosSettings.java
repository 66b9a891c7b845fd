package rsal.ros2.setting;

import java.util.List;

/// How robots are used.
///
/// @param gripper names and positions of the joints of grippers
/// @param bumperTopics of bumpers, in each robot's namespace, in the order of the model; empty for the usual ones
/// @param hasDiagnostics whether errors in the robots' diagnostics are errors of their devices
/// @param useSimTime whether the run has the time of the robots' simulator, by which their messages are stamped
public record RosSettings(
        Safety safety, GripperSettings gripper, List<String> bumperTopics, boolean hasDiagnostics, boolean useSimTime) {
    public RosSettings {
        bumperTopics = List.copyOf(bumperTopics);
    }
}
