/// The robot system `ros2`: what can be set, and which robots there are.
@NullMarked
package rsal.ros2.system;

import org.jspecify.annotations.NullMarked;
