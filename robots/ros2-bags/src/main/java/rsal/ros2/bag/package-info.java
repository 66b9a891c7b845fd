/// Bags of rosbag2 in MCAP and sqlite3: scans, odometry, and where the laser is mounted.
@NullMarked
package rsal.ros2.bag;

import org.jspecify.annotations.NullMarked;
