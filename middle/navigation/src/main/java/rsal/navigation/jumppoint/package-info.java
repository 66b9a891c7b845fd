/// Shortest ways, one at a time.
@NullMarked
package rsal.navigation.jumppoint;

import org.jspecify.annotations.NullMarked;
