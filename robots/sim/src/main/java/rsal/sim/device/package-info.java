/// Devices that the simulator makes, by kind: how somebody adds one, and those that are added so.
@NullMarked
package rsal.sim.device;

import org.jspecify.annotations.NullMarked;
