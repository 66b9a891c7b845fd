/// The topics of TF, heard once for all robots that share them.
@NullMarked
package rsal.ros2.transform;

import org.jspecify.annotations.NullMarked;
