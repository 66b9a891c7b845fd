/// Worlds of Gazebo, in the Simulation Description Format (SDF).
@NullMarked
package rsal.gazebo;

import org.jspecify.annotations.NullMarked;
