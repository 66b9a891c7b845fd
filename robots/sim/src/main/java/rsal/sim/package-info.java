/// Simulated robots and their devices, and the step in which all of them move, sense and report.
@NullMarked
package rsal.sim;

import org.jspecify.annotations.NullMarked;
