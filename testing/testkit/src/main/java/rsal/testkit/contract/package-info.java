/// What every device and robot system owes to those who use it, as tests: one abstract class per device interface
/// and one for robot systems. Who makes a device extends its contract, says what it cannot do, and is then known to
/// behave like the others.
@NullMarked
package rsal.testkit.contract;

import org.jspecify.annotations.NullMarked;
