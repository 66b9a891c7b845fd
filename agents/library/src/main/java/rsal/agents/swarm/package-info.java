/// Robots that follow simple rules by what they hear of their neighbors, without a leader: flocking, aggregation,
/// dispersion, formation by consensus; and the metrics of such swarms.
@NullMarked
package rsal.agents.swarm;

import org.jspecify.annotations.NullMarked;
