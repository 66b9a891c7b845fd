/// Robots behind a rosbridge server (`rosbridge_suite`, protocol 2): a link over WebSocket, for ROS 1 and for
/// networks that DDS does not cross. [rsal.ros2.rosbridge.RosbridgeLink] is what others open; messages come
/// as JSON or CBOR and become CDR, as all else reads it.
@NullMarked
package rsal.ros2.rosbridge;

import org.jspecify.annotations.NullMarked;
