package rsal.ros2.rosbridge;

import java.time.Duration;
import java.util.Set;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosTopic;

/// How a server sends the messages of a topic where the network is slow.
///
/// @param throttle between two messages, at least; zero for all of them
/// @param waiting how many wait at the server at most, the newest ones
record TopicDelivery(Duration throttle, int waiting) {
    private static final int WAITING = 20; // of topics that are to arrive, as updates of maps
    private static final int MANY = 100; // of topics on which several nodes publish a part each

    /// Each message has all that its sensor measures, so that the newest is enough.
    private static final Set<String> READINGS = Set.of(
            "geometry_msgs/msg/PoseArray",
            "nav2_msgs/msg/ParticleCloud",
            "nav_msgs/msg/OccupancyGrid",
            "nav_msgs/msg/Odometry",
            "sensor_msgs/msg/BatteryState",
            "sensor_msgs/msg/CompressedImage",
            "sensor_msgs/msg/Image",
            "sensor_msgs/msg/Imu",
            "sensor_msgs/msg/LaserScan",
            "sensor_msgs/msg/PointCloud2",
            "sensor_msgs/msg/Range",
            "vision_msgs/msg/Detection2DArray");

    /// A time that comes less often makes all that follows it go in steps.
    private static final String CLOCK = "rosgraph_msgs/msg/Clock";

    private static final Set<String> PARTS =
            Set.of("diagnostic_msgs/msg/DiagnosticArray", "sensor_msgs/msg/JointState", "tf2_msgs/msg/TFMessage");

    /// @param throttle of readings of sensors
    static TopicDelivery of(RosTopic topic, Profile profile, Duration throttle) {
        if (profile == Profile.SENSOR_DATA && READINGS.contains(topic.type())) {
            return new TopicDelivery(throttle, 1);
        }
        if (topic.type().equals(CLOCK)) {
            return new TopicDelivery(Duration.ZERO, 1);
        }
        return new TopicDelivery(Duration.ZERO, PARTS.contains(topic.type()) ? MANY : WAITING);
    }
}
