package rsal.ros2.device;

/// How robots are used.
///
/// @param gripper names and positions of the joints of grippers
/// @param hasDiagnostics whether errors in the robots' diagnostics are errors of their devices
public record RosSettings(Safety safety, GripperSettings gripper, boolean hasDiagnostics) {}
