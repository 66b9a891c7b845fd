/// Topics of ROS 2: who publishes and subscribes, and messages as bytes. [rsal.ros2.link.RosLink] is what all
/// else uses; [rsal.ros2.link.RtpsLink] speaks DDS.
@NullMarked
package rsal.ros2.link;

import org.jspecify.annotations.NullMarked;
