package rsal.navigation.amcl;

import java.util.Arrays;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;

/// What localization knows of a map, computed once. Never changes; robots that share a map and a kind of sensor share
/// it.
public final class LocalizationMap {
    /// On so much free floor [m²] a robot is searched for that may be anywhere. On more of it a search takes longer
    /// than
    /// anybody waits.
    public static final double MOST_SEARCHED = 90_000;

    private static final double COARSE_DEVIATION = 0.35; // half of what the coarse search's steps miss
    private static final double COARSE_CELL = 0.15; // m

    /// Distances are those of the middles of cells. Where cells are larger than this [m], beams would seem to end
    /// beside walls by half of one, so they are split.
    private static final double FINE_CELL = 0.05;

    private static final long MOST_CELLS = 16_000_000; // that cells are split into

    final OccupancyGrid grid;
    final DistanceField toOccupied;
    final DistanceField toFace;
    final LikelihoodField walls;
    final BeamModel reaches;

    /// Blurred and of larger cells, so that a search over the whole map finds it in the processor's cache.
    final LikelihoodField nearWalls;

    final double coarseResolution;
    final double deviation;
    private final double freeFloor; // m²
    private Optional<StridedField> nearWallsByStep = Optional.empty(); // until the first search

    /// @param deviation how far hits are from the walls of the map [m]
    /// @param randomShare of readings that have nothing to do with the map
    public LocalizationMap(OccupancyGrid map, double deviation, double randomShare) {
        this.grid = split(map, parts(map));
        this.toOccupied = DistanceField.toOccupied(grid);
        this.toFace = DistanceField.toFace(grid, deviation);
        this.deviation = deviation;
        this.freeFloor = free(map) * map.resolution() * map.resolution();
        this.walls = new LikelihoodField(grid, toFace, deviation, randomShare);
        this.reaches = new BeamModel(toOccupied, OutOfMapModel.of(grid), deviation, randomShare);
        OccupancyGrid coarse = pooled(grid, Math.max(1, (int) Math.round(COARSE_CELL / grid.resolution())));
        this.coarseResolution = coarse.resolution();
        this.nearWalls = new LikelihoodField(
                coarse, DistanceField.toOccupied(coarse), Math.max(deviation, COARSE_DEVIATION), randomShare);
    }

    /// How many cells the places are apart that a search tries.
    int searchStep() {
        return Math.max(1, (int) Math.round(GlobalSearch.STEP / grid.resolution()));
    }

    /// [#nearWalls] sorted for these places. Any thread may ask.
    synchronized StridedField nearWallsByStep() {
        StridedField field = nearWallsByStep.orElseGet(() -> new StridedField(
                nearWalls, (int) Math.max(1, Math.round(searchStep() * grid.resolution() / coarseResolution))));
        nearWallsByStep = Optional.of(field);
        return field;
    }

    private static long free(OccupancyGrid map) {
        long count = 0;
        for (byte cell : map.cells()) {
            count += cell == OccupancyGrid.FREE ? 1 : 0;
        }
        return count;
    }

    /// How much floor is known to be free [m²].
    public double freeFloor() {
        return freeFloor;
    }

    /// Whether a robot that may be anywhere on it is searched for. On others it must be told where it is, and does not
    /// find itself again once it is lost.
    public boolean isSearchable() {
        return freeFloor <= MOST_SEARCHED;
    }

    /// In how many parts along each side cells are split.
    private static int parts(OccupancyGrid map) {
        double fine = Math.ceil(map.resolution() / FINE_CELL - 0.01); // as 0.0500001 is 0.05
        double most = Math.floor(Math.sqrt((double) MOST_CELLS / map.cells().length));
        return (int) Math.max(1, Math.min(fine, most));
    }

    /// The same map of smaller cells.
    private static OccupancyGrid split(OccupancyGrid map, int parts) {
        if (parts == 1) {
            return map;
        }
        int width = map.width() * parts;
        int height = map.height() * parts;
        var cells = new byte[width * height];
        for (int i = 0; i < cells.length; i++) {
            cells[i] = map.cells()[i / width / parts * map.width() + i % width / parts];
        }
        return new OccupancyGrid(width, height, map.resolution() / parts, map.originX(), map.originY(), cells);
    }

    /// A map of larger cells, occupied where any of theirs is; of the others nothing is told.
    private static OccupancyGrid pooled(OccupancyGrid grid, int factor) {
        int width = Math.ceilDiv(grid.width(), factor);
        int height = Math.ceilDiv(grid.height(), factor);
        var cells = new byte[width * height];
        Arrays.fill(cells, OccupancyGrid.UNKNOWN);
        for (int i = 0; i < grid.cells().length; i++) {
            if (grid.cells()[i] == OccupancyGrid.OCCUPIED) {
                cells[i / grid.width() / factor * width + i % grid.width() / factor] = OccupancyGrid.OCCUPIED;
            }
        }
        return new OccupancyGrid(width, height, grid.resolution() * factor, grid.originX(), grid.originY(), cells);
    }
}
