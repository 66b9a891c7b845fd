/// Hunters that are Jadex's own kind of agents: what they want are Jadex goals, what they do Jadex plans.
///
/// Their mind, [rsal.jadex.hunt.mind], is compiled for an older Java, as Jadex rewrites its classes and can't read
/// newer ones; it has the robot do things by an interface.
@NullMarked
package rsal.jadex.hunt;

import org.jspecify.annotations.NullMarked;
