/// The agents of a run on their platform: started, stopped, inspected.
@NullMarked
package rsal.engine.agent;

import org.jspecify.annotations.NullMarked;
