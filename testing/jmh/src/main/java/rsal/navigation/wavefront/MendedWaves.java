package rsal.navigation.wavefront;

import java.util.Arrays;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.bench.place.Cave;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap.Clearance;

/// Waves [1/s] over all of a cave of 2560 × 2560 cells in which a wall of 11 × 11 comes up and goes again, 40 columns
/// from where they spread from: mended, against spread again. What the costs of the changed map take is in
/// [ChangedCosts].
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class MendedWaves {
    private static final int WALL = 11;
    private static final int AWAY = 40;
    private static final Clearance CLEARANCE = new Clearance(0.25, 0.6, 3);

    private CostMap without;
    private CostMap with;
    private CostChanges toWith;
    private CostChanges toWithout;
    private Wave mended;
    private boolean isThere;
    private int source;

    @Setup
    public void draw() {
        OccupancyGrid cave = Cave.draw(128, 0.05, 1);
        without = costs(cave);
        source = cave.cells().length / 2 + cave.width() / 2;
        while (!isWide(cave)) {
            source++;
        }
        byte[] cells = cave.cells().clone();
        for (int row = 0; row < WALL; row++) {
            int first = source + AWAY + row * cave.width();
            Arrays.fill(cells, first, first + WALL, OccupancyGrid.OCCUPIED);
        }
        with = costs(new OccupancyGrid(
                cave.width(), cave.height(), cave.resolution(), cave.originX(), cave.originY(), cells));
        toWith = CostChanges.between(without, with).orElseThrow();
        toWithout = CostChanges.between(with, without).orElseThrow();
        mended = new Wave(without);
        mended.start(source);
        mended.spread(-1);
        for (int time = 0; time < 2; time++) {
            check(kernel(), slow());
        }
    }

    private static CostMap costs(OccupancyGrid grid) {
        return CostMap.of(grid, DistanceField.toNotFree(grid), CLEARANCE);
    }

    /// Whether the source and the place of the wall are far from walls.
    private boolean isWide(OccupancyGrid cave) {
        for (int cell = source - AWAY; cell < source + 2 * AWAY; cell++) {
            if (!without.isOpen(cell) || !without.isOpen(cell + 2 * WALL * cave.width())) {
                return false;
            }
        }
        return true;
    }

    private void check(Wave quick, Wave slow) {
        int reached = 0;
        for (int cell = 0; cell < without.ground().length; cell++) {
            if ((isThere ? with : without).isOpen(cell)) {
                if (quick.at(cell) != slow.at(cell)) {
                    throw new IllegalStateException("Cell %d costs %d, %d by a wave from the start."
                            .formatted(cell, quick.at(cell), slow.at(cell)));
                }
                reached += slow.at(cell) != Wave.UNREACHED ? 1 : 0;
            }
        }
        if (reached < without.ground().length / 3) {
            throw new IllegalStateException("Only %d cells were reached.".formatted(reached));
        }
    }

    @Benchmark
    public Wave kernel() {
        mended = mended.over(isThere ? toWithout : toWith).orElseThrow();
        mended.spread(-1);
        isThere = !isThere;
        return mended;
    }

    @Benchmark
    public Wave slow() {
        Wave anew = new Wave(isThere ? with : without);
        anew.start(source);
        anew.spread(-1);
        return anew;
    }
}
