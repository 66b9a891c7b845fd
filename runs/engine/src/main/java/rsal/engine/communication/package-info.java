/// Messages on their way between agents: range, loss, delay and faults of the radio, and their counts.
@NullMarked
package rsal.engine.communication;

import org.jspecify.annotations.NullMarked;
