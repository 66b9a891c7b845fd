package rsal.agents.patrol.strategy;

import rsal.settings.Arguments;

/// Each robot has places of its own: as MSP of D. Portugal and R. Rocha, "MSP algorithm: multi-robot patrolling
/// based on territory allocation using balanced graph partitioning" (2010). Differs in that places are divided
/// for the shortest longest tour ([TourSearch]), not into parts of equal size.
public final class PartitionTours implements PatrolStrategyType {

    @Override
    public String key() {
        return "partition";
    }

    @Override
    public String description() {
        return "A tour for each robot, with the longest tour as short as possible.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new TourFollower((graph, members) -> new TourSearch(graph).partition(members), 0, false);
    }
}
