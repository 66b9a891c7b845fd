/// How robots of ROS 2 are used, as people set it.
@NullMarked
package rsal.ros2.setting;

import org.jspecify.annotations.NullMarked;
