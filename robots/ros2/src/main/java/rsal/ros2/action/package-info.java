/// Services and actions of ROS 2, as their client and as their server.
@NullMarked
package rsal.ros2.action;

import org.jspecify.annotations.NullMarked;
