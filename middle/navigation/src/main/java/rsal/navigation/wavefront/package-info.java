/// Global planning: the cheapest way over a map, by a wave that spreads from the goal.
@NullMarked
package rsal.navigation.wavefront;

import org.jspecify.annotations.NullMarked;
