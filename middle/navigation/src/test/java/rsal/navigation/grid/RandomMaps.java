package rsal.navigation.grid;

import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;

/// Maps of random cells.
public final class RandomMaps {
    private RandomMaps() {}

    /// @param occupied share of cells that are walls; a tenth as many are unknown
    public static OccupancyGrid of(RandomGenerator random, int width, int height, double occupied) {
        var cells = new byte[width * height];
        for (int i = 0; i < cells.length; i++) {
            double drawn = random.nextDouble();
            cells[i] = drawn < occupied
                    ? OccupancyGrid.OCCUPIED
                    : drawn < 1.1 * occupied ? OccupancyGrid.UNKNOWN : OccupancyGrid.FREE;
        }
        return new OccupancyGrid(width, height, 0.05, -1, 2, cells);
    }
}
