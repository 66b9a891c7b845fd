/// How hunters decide where they drive: strategies as plugins, and the floor as they see it.
@NullMarked
package rsal.agents.pursuit.strategy;

import org.jspecify.annotations.NullMarked;
