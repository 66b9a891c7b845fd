/// Devices of robots of ROS 2. All of it lives on the scheduler's thread.
@NullMarked
package rsal.ros2.device;

import org.jspecify.annotations.NullMarked;
