/// Avoidance by a vector field histogram.
@NullMarked
package rsal.navigation.vfh;

import org.jspecify.annotations.NullMarked;
