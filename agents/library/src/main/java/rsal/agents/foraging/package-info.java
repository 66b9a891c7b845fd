/// Robots that find things and bring them to depots.
@NullMarked
package rsal.agents.foraging;

import org.jspecify.annotations.NullMarked;
