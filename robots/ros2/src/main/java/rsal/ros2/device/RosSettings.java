package rsal.ros2.device;

/// How robots are used.
///
/// @param gripper names and positions of the joints of grippers
/// @param useSimTime whether the run has the time of the robots' simulator, by which their messages are stamped
public record RosSettings(Safety safety, GripperSettings gripper, boolean useSimTime) {}
