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

    /// The same with a few rectangles of walls, of nothing and of what is unknown; at times it is cut or grows on some
    /// sides.
    public static OccupancyGrid changed(OccupancyGrid before, RandomGenerator random) {
        boolean isMoved = random.nextInt(3) == 0;
        int left = isMoved ? random.nextInt(-5, 6) : 0;
        int low = isMoved ? random.nextInt(-5, 6) : 0;
        int width = before.width() + left + (isMoved ? random.nextInt(-5, 6) : 0);
        int height = before.height() + low + (isMoved ? random.nextInt(-5, 6) : 0);
        byte beyond = value(random);
        var cells = new byte[width * height];
        for (int cell = 0; cell < cells.length; cell++) {
            int column = cell % width - left;
            int row = cell / width - low;
            cells[cell] = before.contains(column, row) ? before.at(column, row) : beyond;
        }
        int rectangles = random.nextInt(4);
        for (int i = 0; i < rectangles; i++) {
            int firstColumn = random.nextInt(width);
            int firstRow = random.nextInt(height);
            int columns = 1 + random.nextInt(random.nextBoolean() ? 3 : 30);
            int rows = 1 + random.nextInt(random.nextBoolean() ? 3 : 30);
            byte value = value(random);
            for (int row = firstRow; row < Math.min(height, firstRow + rows); row++) {
                for (int column = firstColumn; column < Math.min(width, firstColumn + columns); column++) {
                    cells[row * width + column] = value;
                }
            }
        }
        double side = before.resolution();
        return new OccupancyGrid(
                width, height, side, before.originX() - left * side, before.originY() - low * side, cells);
    }

    private static byte value(RandomGenerator random) {
        return random.nextBoolean()
                ? OccupancyGrid.FREE
                : random.nextBoolean() ? OccupancyGrid.OCCUPIED : OccupancyGrid.UNKNOWN;
    }
}
