/// The simulated world of a run and its robots' devices: what comes and goes, and mixed reality.
@NullMarked
package rsal.engine.world;

import org.jspecify.annotations.NullMarked;
