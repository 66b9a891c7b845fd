package rsal.sim.world;

import java.util.Arrays;

/// Circles on the plane, in square cells by where their centers are, so that only those nearby are looked at.
/// Circles beyond the border are in the cells along it.
final class BodyGrid {
    private static final double CELL = 2; // [m]
    private static final int MOST_CELLS = 1 << 22;
    private static final int NONE = -1;

    private final double left;
    private final double bottom;
    private final double cellsPerMeter;
    private final int columns;
    private final int rows;
    private final int[] first; // of each cell's list
    private int[] next = {}; // by circle
    private int[] previous = {};
    private int[] cell = {}; // NONE when it is not there
    private double[] x = {};
    private double[] y = {};
    private double[] radius = {};
    private double largest;

    BodyGrid(double left, double bottom, double sizeX, double sizeY) {
        double side = Math.max(CELL, Math.sqrt(sizeX * sizeY / MOST_CELLS));
        this.left = left;
        this.bottom = bottom;
        this.cellsPerMeter = 1 / side;
        this.columns = 1 + (int) (sizeX / side);
        this.rows = 1 + (int) (sizeY / side);
        this.first = new int[columns * rows];
        Arrays.fill(first, NONE);
    }

    /// Adds a circle or moves it.
    void put(int circle, double centerX, double centerY, double itsRadius) {
        if (circle >= cell.length) {
            grow(Math.max(circle + 1, 2 * cell.length));
        }
        x[circle] = centerX;
        y[circle] = centerY;
        radius[circle] = itsRadius;
        largest = Math.max(largest, itsRadius);
        int now = row(centerY) * columns + column(centerX);
        if (now != cell[circle]) {
            remove(circle);
            cell[circle] = now;
            next[circle] = first[now];
            previous[circle] = NONE;
            if (next[circle] != NONE) {
                previous[next[circle]] = circle;
            }
            first[now] = circle;
        }
    }

    /// Takes a circle away, if it is there.
    void remove(int circle) {
        int was = cell[circle];
        if (was == NONE) {
            return;
        }
        if (previous[circle] == NONE) {
            first[was] = next[circle];
        } else {
            next[previous[circle]] = next[circle];
        }
        if (next[circle] != NONE) {
            previous[next[circle]] = previous[circle];
        }
        cell[circle] = NONE;
    }

    /// Finds the circles that reach into another one.
    ///
    /// @param found filled with them, in no order that means anything; made larger when it is too small
    /// @return how many there are
    int near(double centerX, double centerY, double within, Found found) {
        double reach = within + largest;
        int firstColumn = column(centerX - reach);
        int lastColumn = column(centerX + reach);
        int firstRow = row(centerY - reach);
        int lastRow = row(centerY + reach);
        found.count = 0;
        for (int row = firstRow; row <= lastRow; row++) {
            for (int at = row * columns + firstColumn; at <= row * columns + lastColumn; at++) {
                for (int circle = first[at]; circle != NONE; circle = next[circle]) {
                    double dx = x[circle] - centerX;
                    double dy = y[circle] - centerY;
                    double apart = within + radius[circle];
                    if (dx * dx + dy * dy < apart * apart) {
                        found.add(circle);
                    }
                }
            }
        }
        return found.count;
    }

    /// Circles that were found. Kept by who asks, as many may ask at once.
    static final class Found {
        int[] circles = new int[16];
        int count;

        private void add(int circle) {
            if (count == circles.length) {
                circles = Arrays.copyOf(circles, 2 * count);
            }
            circles[count++] = circle;
        }
    }

    private void grow(int size) {
        int from = cell.length;
        next = Arrays.copyOf(next, size);
        previous = Arrays.copyOf(previous, size);
        cell = Arrays.copyOf(cell, size);
        x = Arrays.copyOf(x, size);
        y = Arrays.copyOf(y, size);
        radius = Arrays.copyOf(radius, size);
        Arrays.fill(cell, from, size, NONE);
    }

    private int column(double at) {
        return (int) Math.clamp((at - left) * cellsPerMeter, 0.0, columns - 1.0);
    }

    private int row(double at) {
        return (int) Math.clamp((at - bottom) * cellsPerMeter, 0.0, rows - 1.0);
    }
}
