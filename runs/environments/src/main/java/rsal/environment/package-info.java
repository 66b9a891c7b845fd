/// Scenarios as environments for learning ([Environments]): observations as numbers, actions, and many worlds at once.
@NullMarked
package rsal.environment;

import org.jspecify.annotations.NullMarked;
