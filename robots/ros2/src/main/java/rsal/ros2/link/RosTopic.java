package rsal.ros2.link;

/// A topic of ROS 2.
///
/// @param name with its namespace: `/robot1/scan`
/// @param type `sensor_msgs/msg/LaserScan`
public record RosTopic(String name, String type) {}
