/// Robots that map a place and look around in it.
@NullMarked
package rsal.agents.exploration;

import org.jspecify.annotations.NullMarked;
