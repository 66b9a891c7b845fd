package rsal.ros2.device;

/// How robots are used.
///
/// @param gripper names and positions of the joints of grippers
public record RosSettings(Safety safety, GripperSettings gripper) {}
