/// The robots of a run: found in their robot systems, with their poses.
@NullMarked
package rsal.engine.robot;

import org.jspecify.annotations.NullMarked;
