/// Robots, what a kind of robot is like, and the contract of device drivers, which make devices of a robot's other
/// devices.
@NullMarked
package rsal.robot;

import org.jspecify.annotations.NullMarked;
