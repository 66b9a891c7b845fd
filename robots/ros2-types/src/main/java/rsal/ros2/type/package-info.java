/// Definitions of message types: `.msg`, `.srv` and `.action` texts, those of the distributions of ROS 2, and their
/// hashes.
@NullMarked
package rsal.ros2.type;

import org.jspecify.annotations.NullMarked;
