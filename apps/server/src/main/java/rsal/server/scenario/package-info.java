/// Which scenarios can be run, and how a run is asked for.
@NullMarked
package rsal.server.scenario;

import org.jspecify.annotations.NullMarked;
