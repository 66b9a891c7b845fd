package rsal.navigation.wavefront;

import java.util.Arrays;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.bench.place.Cave;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.Difference;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap.Clearance;

/// Distances and costs [1/s] of a cave of 2560 × 2560 cells onto which a wall of 11 × 11 has come, at times with some
/// columns and rows more: taken over from the cave before, against computed again.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ChangedCosts {
    private static final int WALL = 11;
    private static final Clearance CLEARANCE = new Clearance(0.25, 0.6, 3);

    /// Columns and rows by which it has grown on the left and below.
    @Param({"0", "3"})
    int grown;

    private OccupancyGrid cave;
    private OccupancyGrid changed;
    private DistanceField toNotFree;
    private CostMap costs;

    @Setup
    public void draw() {
        cave = Cave.draw(128, 0.05, 1);
        toNotFree = DistanceField.toNotFree(cave);
        costs = CostMap.of(cave, toNotFree, CLEARANCE);
        changed = changed();
        if (!Arrays.equals(kernel().ground(), slow().ground()) || !Arrays.equals(kernel().shore(), slow().shore())) {
            throw new IllegalStateException("The costs that were taken over differ from those computed again.");
        }
    }

    private OccupancyGrid changed() {
        int side = cave.width() + grown;
        var cells = new byte[side * side];
        Arrays.fill(cells, OccupancyGrid.UNKNOWN);
        for (int row = 0; row < cave.height(); row++) {
            System.arraycopy(cave.cells(), row * cave.width(), cells, (row + grown) * side + grown, cave.width());
        }
        int open = cells.length / 2;
        while (cells[open] != OccupancyGrid.FREE) {
            open++;
        }
        for (int row = 0; row < WALL; row++) {
            Arrays.fill(cells, open + row * side, open + row * side + WALL, OccupancyGrid.OCCUPIED);
        }
        double origin = cave.originX() - grown * cave.resolution();
        return new OccupancyGrid(side, side, cave.resolution(), origin, origin, cells);
    }

    @Benchmark
    public CostMap kernel() {
        Difference difference = Difference.between(cave, changed).orElseThrow();
        return costs.over(difference, DistanceField.toNotFree(difference, toNotFree));
    }

    @Benchmark
    public CostMap slow() {
        return CostMap.of(changed, DistanceField.toNotFree(changed), CLEARANCE);
    }
}
