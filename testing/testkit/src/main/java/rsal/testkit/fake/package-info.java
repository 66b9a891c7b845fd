/// A robot system without physics, and software devices without algorithms, for tests of what stands on them. Moves
/// are exact, readings perfect unless a test scripts them, and everything commanded is kept to be looked at.
@NullMarked
package rsal.testkit.fake;

import org.jspecify.annotations.NullMarked;
