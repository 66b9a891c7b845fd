/// Faults that a scenario plans: of robots, devices and communication.
@NullMarked
package rsal.scenario.fault;

import org.jspecify.annotations.NullMarked;
