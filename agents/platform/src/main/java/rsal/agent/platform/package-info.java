/// The runtime of agents: hands them messages one at a time, and knows who is there.
@NullMarked
package rsal.agent.platform;

import org.jspecify.annotations.NullMarked;
