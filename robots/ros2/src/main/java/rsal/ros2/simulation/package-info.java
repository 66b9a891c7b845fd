/// Control of a run by `simulation_interfaces`: its state, its time, its entities, and where these really are.
@NullMarked
package rsal.ros2.simulation;

import org.jspecify.annotations.NullMarked;
