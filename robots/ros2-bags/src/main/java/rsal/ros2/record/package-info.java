/// Writes bags of ROS 2, as rosbag2 writes them: MCAP, and `metadata.yaml`.
@NullMarked
package rsal.ros2.record;

import org.jspecify.annotations.NullMarked;
