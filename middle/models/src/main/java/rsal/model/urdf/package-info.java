/// Robot descriptions of ROS (URDF), made robot models of.
@NullMarked
package rsal.model.urdf;

import org.jspecify.annotations.NullMarked;
