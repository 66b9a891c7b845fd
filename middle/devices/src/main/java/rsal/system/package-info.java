/// The contract of robot systems: whatever simulates robots or drives real ones.
@NullMarked
package rsal.system;

import org.jspecify.annotations.NullMarked;
