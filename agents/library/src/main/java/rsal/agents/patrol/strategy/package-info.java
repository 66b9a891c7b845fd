/// Patrol strategies: which place a robot visits next, decided on path lengths between places. Each robot
/// decides for itself, by what the team's messages say.
@NullMarked
package rsal.agents.patrol.strategy;

import org.jspecify.annotations.NullMarked;
