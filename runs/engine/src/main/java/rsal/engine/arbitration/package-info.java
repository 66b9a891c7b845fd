/// Who commands a robot: its agents, people, or a client of a bridge. People come first.
@NullMarked
package rsal.engine.arbitration;

import org.jspecify.annotations.NullMarked;
