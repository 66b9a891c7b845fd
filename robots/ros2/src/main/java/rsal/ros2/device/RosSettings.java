package rsal.ros2.device;

/// How robots are used.
///
/// @param gripper what those are called that have one
public record RosSettings(Safety safety, GripperSettings gripper) {}
