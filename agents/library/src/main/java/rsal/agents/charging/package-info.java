/// Robots that mind their batteries and share chargers.
@NullMarked
package rsal.agents.charging;

import org.jspecify.annotations.NullMarked;
