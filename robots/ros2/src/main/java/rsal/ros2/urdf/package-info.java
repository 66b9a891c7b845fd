/// Robot models as descriptions in URDF.
@NullMarked
package rsal.ros2.urdf;

import org.jspecify.annotations.NullMarked;
