/// Avoidance by the smoothed nearness diagram: one rule for all situations.
@NullMarked
package rsal.navigation.snd;

import org.jspecify.annotations.NullMarked;
