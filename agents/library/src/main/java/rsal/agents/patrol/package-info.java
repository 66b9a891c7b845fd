/// Teams that watch places.
@NullMarked
package rsal.agents.patrol;

import org.jspecify.annotations.NullMarked;
