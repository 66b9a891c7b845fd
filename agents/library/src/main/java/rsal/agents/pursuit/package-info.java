/// Hunters and prey.
@NullMarked
package rsal.agents.pursuit;

import org.jspecify.annotations.NullMarked;
