package rsal.navigation.grid;

import java.util.Arrays;
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
    /// sides, by few cells or by many.
    public static OccupancyGrid changed(OccupancyGrid before, RandomGenerator random) {
        int[] more = more(before, random);
        int left = more[0];
        int low = more[1];
        int width = before.width() + left + more[2];
        int height = before.height() + low + more[3];
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
            int endColumn = Math.min(width, firstColumn + 1 + random.nextInt(random.nextBoolean() ? 3 : 30));
            int endRow = Math.min(height, firstRow + 1 + random.nextInt(random.nextBoolean() ? 3 : 30));
            byte value = value(random);
            for (int row = firstRow; row < endRow; row++) {
                for (int column = firstColumn; column < endColumn; column++) {
                    cells[row * width + column] = value;
                }
            }
        }
        double side = before.resolution();
        return new OccupancyGrid(
                width, height, side, before.originX() - left * side, before.originY() - low * side, cells);
    }

    /// By how many cells it grows on the left, below, on the right and above: mostly by none, at times by few on all
    /// sides
    /// or by many on one.
    private static int[] more(OccupancyGrid before, RandomGenerator random) {
        var more = new int[4];
        int kind = random.nextInt(6);
        if (kind == 0) {
            int most = Math.min(60, Math.min(before.width(), before.height()) / 3);
            more[random.nextInt(4)] = random.nextInt(-most, most + 1);
        } else if (kind < 3) {
            Arrays.setAll(more, _ -> random.nextInt(-5, 6));
        }
        return more;
    }

    private static byte value(RandomGenerator random) {
        return random.nextBoolean()
                ? OccupancyGrid.FREE
                : random.nextBoolean() ? OccupancyGrid.OCCUPIED : OccupancyGrid.UNKNOWN;
    }
}
