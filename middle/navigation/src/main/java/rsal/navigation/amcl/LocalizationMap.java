package rsal.navigation.amcl;

import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;

/// What localization knows of a map, computed once. Immutable; robots that share a map and a kind of sensor share
/// it.
public final class LocalizationMap {
    private static final double COARSE_DEVIATION = 0.35; // half of what the coarse search's steps miss

    final OccupancyGrid grid;
    final DistanceField toOccupied;
    final DistanceField toNotFree;
    final LikelihoodField walls;
    final LikelihoodField nearWalls;
    final double deviation;

    /// @param deviation how far hits are from the walls of the map [m]
    /// @param randomShare of readings that have nothing to do with the map
    public LocalizationMap(OccupancyGrid grid, double deviation, double randomShare) {
        this.grid = grid;
        this.toOccupied = DistanceField.toOccupied(grid);
        this.toNotFree = DistanceField.toNotFree(grid);
        this.deviation = deviation;
        this.walls = new LikelihoodField(grid, toOccupied, deviation, randomShare);
        this.nearWalls = new LikelihoodField(grid, toOccupied, Math.max(deviation, COARSE_DEVIATION), randomShare);
    }
}
