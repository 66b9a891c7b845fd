/// Where frames are in others at a time (tf2), by the topics `tf` and `tf_static`.
@NullMarked
package rsal.ros2.tf;

import org.jspecify.annotations.NullMarked;
