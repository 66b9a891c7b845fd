package rsal.bench.place;

import java.util.SplittableRandom;
import rsal.data.OccupancyGrid;

/// A map of caves, the same each time: noise that a cellular automaton smooths, of which a cell is wall when most
/// around it are (Johnson, Yannakakis and Togelius, Cellular automata for real-time generation of infinite cave
/// levels, 2010), enlarged to fine cells. Nothing leads out of them.
public final class Cave {
    private static final double COARSE = 0.8; // [m]; halls get some meters wide
    private static final double WALLS_AT_FIRST = 0.44;
    private static final int GENERATIONS = 5;

    private Cave() {}

    /// @param side length of the square [m], with the origin in its middle
    /// @param resolution side of a cell [m]
    public static OccupancyGrid draw(double side, double resolution, long seed) {
        int coarse = (int) Math.round(side / COARSE);
        boolean[][] rock = grow(coarse, new SplittableRandom(seed));
        int fine = (int) Math.round(side / resolution);
        byte[] cells = new byte[fine * fine];
        for (int row = 0; row < fine; row++) {
            for (int column = 0; column < fine; column++) {
                double x = (column + 0.5) * coarse / fine - 0.5;
                double y = (row + 0.5) * coarse / fine - 0.5;
                boolean edge = row == 0 || column == 0 || row == fine - 1 || column == fine - 1;
                cells[row * fine + column] =
                        edge || density(rock, x, y) > 0.5 ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
            }
        }
        return new OccupancyGrid(fine, fine, resolution, -side / 2, -side / 2, cells);
    }

    private static boolean[][] grow(int size, SplittableRandom random) {
        boolean[][] rock = new boolean[size][size];
        for (boolean[] row : rock) {
            for (int x = 0; x < size; x++) {
                row[x] = random.nextDouble() < WALLS_AT_FIRST;
            }
        }
        for (int generation = 0; generation < GENERATIONS; generation++) {
            boolean[][] next = new boolean[size][size];
            for (int y = 0; y < size; y++) {
                for (int x = 0; x < size; x++) {
                    next[y][x] = around(rock, x, y) >= 5;
                }
            }
            rock = next;
        }
        return rock;
    }

    /// How many of a cell and its eight neighbors are rock; outside all is.
    private static int around(boolean[][] rock, int x, int y) {
        int count = 0;
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                count += isRock(rock, x + dx, y + dy) ? 1 : 0;
            }
        }
        return count;
    }

    private static boolean isRock(boolean[][] rock, int x, int y) {
        return x < 0 || y < 0 || x >= rock.length || y >= rock.length || rock[y][x];
    }

    /// Between the middles of four cells, bilinearly, so that walls are slanted and round.
    private static double density(boolean[][] rock, double x, double y) {
        int left = (int) Math.floor(x);
        int bottom = (int) Math.floor(y);
        double u = x - left;
        double v = y - bottom;
        double low = mix(isRock(rock, left, bottom), isRock(rock, left + 1, bottom), u);
        double high = mix(isRock(rock, left, bottom + 1), isRock(rock, left + 1, bottom + 1), u);
        return low + (high - low) * v;
    }

    private static double mix(boolean from, boolean to, double part) {
        return (from ? 1 - part : 0) + (to ? part : 0);
    }
}
