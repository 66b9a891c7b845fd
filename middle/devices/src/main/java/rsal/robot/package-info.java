/// Robots, their models, and the contracts of those who supply them: robot systems and device drivers.
@NullMarked
package rsal.robot;

import org.jspecify.annotations.NullMarked;
