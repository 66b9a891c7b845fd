/// What messages of ROS 2 say, as values of [rsal.data].
@NullMarked
package rsal.ros2.message;

import org.jspecify.annotations.NullMarked;
