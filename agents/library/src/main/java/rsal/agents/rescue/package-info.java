/// Teams that find and help victims.
@NullMarked
package rsal.agents.rescue;

import org.jspecify.annotations.NullMarked;
