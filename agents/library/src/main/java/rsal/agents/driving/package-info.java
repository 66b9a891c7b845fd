/// Robots that drive where people or other agents want them, and answer what ways would cost them.
@NullMarked
package rsal.agents.driving;

import org.jspecify.annotations.NullMarked;
