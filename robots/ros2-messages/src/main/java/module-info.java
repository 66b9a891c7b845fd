/// Messages of ROS 2 as values of RSAL: scans, odometry, and where frames are (TF). For bags, robots and bridges alike.
/// Knows nothing of networks, devices or files.
module rsal.ros2.messages {
    requires transitive rsal.data;
    requires transitive rsal.ros2.types;
    requires static org.jspecify;

    exports rsal.ros2.message;
    exports rsal.ros2.tf;
}
