/// How a robot's own programs say that its devices are: diagnostics, and nodes with a lifecycle.
@NullMarked
package rsal.ros2.health;

import org.jspecify.annotations.NullMarked;
