/// Behaviors in a subsumption stack (R. Brooks, "A robust layered control system for a mobile robot", 1986), the
/// layers of the thesis's Pioneers, and the pilot that lets a stack drive a robot.
@NullMarked
package rsal.behavior;

import org.jspecify.annotations.NullMarked;
