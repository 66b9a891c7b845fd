/// Avoidance by the dynamic window approach, as it was first published: what others are measured by.
@NullMarked
package rsal.navigation.dwa;

import org.jspecify.annotations.NullMarked;
