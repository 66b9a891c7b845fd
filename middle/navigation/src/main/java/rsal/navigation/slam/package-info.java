/// Maps without known poses: a graph of poses and of how they lie to each other, closed where a robot comes
/// back.
@NullMarked
package rsal.navigation.slam;

import org.jspecify.annotations.NullMarked;
