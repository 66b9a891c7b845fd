/// Robots of a run, published to programs of ROS 2.
@NullMarked
package rsal.ros2.bridge;

import org.jspecify.annotations.NullMarked;
