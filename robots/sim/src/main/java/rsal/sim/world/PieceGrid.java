package rsal.sim.world;

import java.util.Arrays;

/// Circles around pieces, in square cells by where their centers are, so that only those nearby are looked at. Those
/// beyond the border are in the cells along it.
final class PieceGrid {
    private static final double CELL = 2; // [m]
    private static final int MOST_CELLS_ACROSS = 2000;
    private static final int NONE = -1;

    private final double left;
    private final double bottom;
    private final double cellsPerMeter;
    private final int columns;
    private final int rows;
    private final int[] first; // of each cell's list
    private int[] next = {}; // by slot
    private int[] previous = {};
    private int[] cell = {}; // NONE when it is not there
    private double[] x = {};
    private double[] y = {};
    private double[] radius = {};
    private double largest;

    PieceGrid(Extent extent) {
        double side = Math.max(CELL, Math.max(extent.width(), extent.height()) / MOST_CELLS_ACROSS);
        this.left = extent.left();
        this.bottom = extent.bottom();
        this.cellsPerMeter = 1 / side;
        this.columns = 1 + (int) (extent.width() / side);
        this.rows = 1 + (int) (extent.height() / side);
        this.first = new int[columns * rows];
        Arrays.fill(first, NONE);
    }

    /// Adds the circle around a piece or moves it.
    void put(int slot, double centerX, double centerY, double itsRadius) {
        if (slot >= cell.length) {
            grow(Math.max(slot + 1, 2 * cell.length));
        }
        x[slot] = centerX;
        y[slot] = centerY;
        radius[slot] = itsRadius;
        largest = Math.max(largest, itsRadius);
        int now = row(centerY) * columns + column(centerX);
        if (now != cell[slot]) {
            remove(slot);
            cell[slot] = now;
            next[slot] = first[now];
            previous[slot] = NONE;
            if (next[slot] != NONE) {
                previous[next[slot]] = slot;
            }
            first[now] = slot;
        }
    }

    /// Takes one away, if it is there.
    void remove(int slot) {
        int was = cell[slot];
        if (was == NONE) {
            return;
        }
        if (previous[slot] == NONE) {
            first[was] = next[slot];
        } else {
            next[previous[slot]] = next[slot];
        }
        if (next[slot] != NONE) {
            previous[next[slot]] = previous[slot];
        }
        cell[slot] = NONE;
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
                for (int slot = first[at]; slot != NONE; slot = next[slot]) {
                    double dx = x[slot] - centerX;
                    double dy = y[slot] - centerY;
                    double apart = within + radius[slot];
                    if (dx * dx + dy * dy < apart * apart) {
                        found.add(slot);
                    }
                }
            }
        }
        return found.count;
    }

    /// Slots that were found. Kept by who asks, as many may ask at once.
    static final class Found {
        int[] slots = new int[16];
        int count;

        private void add(int slot) {
            if (count == slots.length) {
                slots = Arrays.copyOf(slots, 2 * count);
            }
            slots[count++] = slot;
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
