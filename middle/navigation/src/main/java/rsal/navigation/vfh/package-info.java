/// Local avoidance: which way to drive now, so that the robot comes nearer to its target and touches nothing.
@NullMarked
package rsal.navigation.vfh;

import org.jspecify.annotations.NullMarked;
