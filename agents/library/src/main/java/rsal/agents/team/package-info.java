/// Members of teams, who bid for what there is to do.
@NullMarked
package rsal.agents.team;

import org.jspecify.annotations.NullMarked;
