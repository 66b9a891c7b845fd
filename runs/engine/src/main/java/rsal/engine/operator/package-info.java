/// What people tell robots to do, and the goals to which they send them.
@NullMarked
package rsal.engine.operator;

import org.jspecify.annotations.NullMarked;
