/// What agents are put together from, whatever their task.
@NullMarked
package rsal.agents.parts;

import org.jspecify.annotations.NullMarked;
