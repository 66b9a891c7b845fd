package rsal.gazebo;

/// The configuration of `ros_gz_bridge` for what was written: which topics of Gazebo are which of ROS 2.
final class BridgeConfig {
    private final StringBuilder text = new StringBuilder("""
            # Topics that ros_gz_bridge passes on between Gazebo and ROS 2:
            # ros2 run ros_gz_bridge parameter_bridge --ros-args -p config_file:=THIS_FILE
            """);

    BridgeConfig() {
        add("/clock", "/clock", "rosgraph_msgs/msg/Clock", "gz.msgs.Clock", "GZ_TO_ROS");
    }

    /// What every robot has.
    ///
    /// @param namespace of the robot, `/robot_1`
    /// @param topics of the robot in Gazebo begin so
    void robot(String namespace, String topics) {
        add(namespace + "/cmd_vel", topics + "/cmd_vel", "geometry_msgs/msg/Twist", "gz.msgs.Twist", "ROS_TO_GZ");
        add(namespace + "/odom", topics + "/odom", "nav_msgs/msg/Odometry", "gz.msgs.Odometry", "GZ_TO_ROS");
        add(namespace + "/tf", topics + "/tf", "tf2_msgs/msg/TFMessage", "gz.msgs.Pose_V", "GZ_TO_ROS");
    }

    /// @param name of its topic
    void laser(String namespace, String topics, String name) {
        add(namespace + "/" + name, topics + "/" + name, "sensor_msgs/msg/LaserScan", "gz.msgs.LaserScan", "GZ_TO_ROS");
    }

    private void add(String ros, String gazebo, String rosType, String gazeboType, String direction) {
        text.append("""
                - ros_topic_name: "%s"
                  gz_topic_name: "%s"
                  ros_type_name: "%s"
                  gz_type_name: "%s"
                  direction: %s
                """.formatted(ros, gazebo, rosType, gazeboType, direction));
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
