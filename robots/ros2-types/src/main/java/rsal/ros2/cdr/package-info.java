/// Messages as bytes: Common Data Representation (CDR), as OMG's DDSI-RTPS and XTypes define it, in the plain form that
/// ROS 2 uses (XCDR1).
@NullMarked
package rsal.ros2.cdr;

import org.jspecify.annotations.NullMarked;
