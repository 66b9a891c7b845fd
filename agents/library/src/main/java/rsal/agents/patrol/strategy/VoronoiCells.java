package rsal.agents.patrol.strategy;

import rsal.settings.Arguments;

/// A tour in each cell of a graph-Voronoi partition, after AHPA (2024); see [PatrolPlan] for what differs.
public final class VoronoiCells implements PatrolStrategyType {

    @Override
    public String key() {
        return "voronoi";
    }

    @Override
    public String description() {
        return "A tour for each robot over the places nearest to one of as many places that are far from each other.";
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new TourFollower(PatrolPlan::voronoi, 0, false);
    }
}
