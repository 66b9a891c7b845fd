package rsal.navigation.amcl;

import java.util.Arrays;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;

/// What localization knows of a map, computed once. Immutable; robots that share a map and a kind of sensor share
/// it.
public final class LocalizationMap {
    private static final double COARSE_DEVIATION = 0.35; // half of what the coarse search's steps miss
    private static final double COARSE_CELL = 0.15; // m

    final OccupancyGrid grid;
    final DistanceField toOccupied;
    final DistanceField toFace;
    final LikelihoodField walls;
    final BeamModel reaches;

    /// Blurred and of larger cells, so that a search over the whole map finds it in the processor's cache.
    final LikelihoodField nearWalls;

    final double coarseResolution;
    final double deviation;

    /// @param deviation how far hits are from the walls of the map [m]
    /// @param randomShare of readings that have nothing to do with the map
    public LocalizationMap(OccupancyGrid grid, double deviation, double randomShare) {
        this.grid = grid;
        this.toOccupied = DistanceField.toOccupied(grid);
        this.toFace = DistanceField.toFace(grid, deviation);
        this.deviation = deviation;
        this.walls = new LikelihoodField(grid, toFace, deviation, randomShare);
        this.reaches = new BeamModel(toOccupied, deviation, randomShare);
        OccupancyGrid coarse = pooled(grid, Math.max(1, (int) Math.round(COARSE_CELL / grid.resolution())));
        this.coarseResolution = coarse.resolution();
        this.nearWalls = new LikelihoodField(
                coarse, DistanceField.toOccupied(coarse), Math.max(deviation, COARSE_DEVIATION), randomShare);
    }

    /// A map of larger cells, occupied where any of theirs is.
    private static OccupancyGrid pooled(OccupancyGrid grid, int factor) {
        int width = Math.ceilDiv(grid.width(), factor);
        int height = Math.ceilDiv(grid.height(), factor);
        var cells = new byte[width * height];
        Arrays.fill(cells, OccupancyGrid.FREE);
        for (int i = 0; i < grid.cells().length; i++) {
            if (grid.cells()[i] == OccupancyGrid.OCCUPIED) {
                cells[i / grid.width() / factor * width + i % grid.width() / factor] = OccupancyGrid.OCCUPIED;
            }
        }
        return new OccupancyGrid(width, height, grid.resolution() * factor, grid.originX(), grid.originY(), cells);
    }
}
