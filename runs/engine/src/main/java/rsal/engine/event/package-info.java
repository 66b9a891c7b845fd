/// The events of a run, its event hash, and the conversations of its agents.
@NullMarked
package rsal.engine.event;

import org.jspecify.annotations.NullMarked;
