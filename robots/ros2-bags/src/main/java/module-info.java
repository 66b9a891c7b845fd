/// Recordings of ROS 2 (bags): written, and read as logs of a robot's laser and odometry.
module rsal.ros2.bags {
    requires com.github.luben.zstd_jni;
    requires rsal.mcap;
    requires rsal.navigation;
    requires rsal.ros2.messages;
    requires static org.jspecify;

    exports rsal.ros2.record;

    provides rsal.navigation.log.LogFormat with
            rsal.ros2.bag.McapBagFormat,
            rsal.ros2.bag.SqliteBagFormat;
}
