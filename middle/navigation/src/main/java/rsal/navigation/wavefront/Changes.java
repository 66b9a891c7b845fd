package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.Optional;
import rsal.data.OccupancyGrid;

/// In which cells one map costs something else than another that lies on the same lattice; each may reach beyond the
/// other, and beyond a map all is blocked.
final class Changes {
    /// Of so many cells one may have changed.
    static final int SHARE = 20;

    private static final double ALIGNED = 1e-6; // of a cell

    private final CostMap from;
    private final CostMap to;
    private final int columns;
    private final int rows;
    private int[] cells = new int[256];
    private int count;

    private Changes(CostMap from, CostMap to, int columns, int rows) {
        this.from = from;
        this.to = to;
        this.columns = columns;
        this.rows = rows;
    }

    /// Empty when more than one of [#SHARE] cells has changed, or the maps' cells do not lie on each other.
    static Optional<Changes> between(CostMap from, CostMap to) {
        OccupancyGrid old = from.grid();
        OccupancyGrid now = to.grid();
        double columns = (old.originX() - now.originX()) / now.resolution();
        double rows = (old.originY() - now.originY()) / now.resolution();
        boolean isAligned = old.resolution() == now.resolution()
                && Math.abs(columns - Math.rint(columns)) < ALIGNED
                && Math.abs(rows - Math.rint(rows)) < ALIGNED
                && Math.abs(columns) < now.width() + old.width() // else they share nothing,
                && Math.abs(rows) < now.height() + old.height(); // and the numbers may be too large
        if (!isAligned) {
            return Optional.empty();
        }
        var changes = new Changes(from, to, (int) Math.rint(columns), (int) Math.rint(rows));
        return changes.compare() ? Optional.of(changes) : Optional.empty();
    }

    CostMap from() {
        return from;
    }

    CostMap to() {
        return to;
    }

    /// The changed ones, by their numbers in the new map, in ascending order. Not to be written to.
    int[] cells() {
        return cells;
    }

    boolean isSameSize() {
        return columns == 0
                && rows == 0
                && from.grid().width() == to.grid().width()
                && from.grid().height() == to.grid().height();
    }

    /// The number that a cell of the old map has in the new one; −1 when it lies beyond that.
    int moved(int cell) {
        int width = from.grid().width();
        int column = cell % width + columns;
        int row = cell / width + rows;
        return to.grid().contains(column, row) ? row * to.grid().width() + column : -1;
    }

    /// What cells of the old map hold, in those of the new one; 0 in what lies beyond.
    int[] moved(int[] field) {
        int width = to.grid().width();
        var moved = new int[to.ground().length];
        for (int row = firstRow(); row < endRow(); row++) {
            int length = endColumn() - firstColumn();
            if (length > 0) {
                System.arraycopy(field, old(row, firstColumn()), moved, row * width + firstColumn(), length);
            }
        }
        return moved;
    }

    /// @return whether they are few; else it has stopped
    private boolean compare() {
        int width = to.grid().width();
        int most = to.ground().length / SHARE;
        for (int row = 0; row < to.grid().height() && count <= most; row++) {
            if (row < firstRow() || row >= endRow() || firstColumn() >= endColumn()) {
                addOpen(row, 0, width);
            } else {
                addOpen(row, 0, firstColumn());
                compare(row);
                addOpen(row, endColumn(), width);
            }
        }
        cells = Arrays.copyOf(cells, count);
        return count <= most;
    }

    private void compare(int row) {
        byte[] before = from.ground();
        byte[] now = to.ground();
        int cell = row * to.grid().width() + firstColumn();
        int end = row * to.grid().width() + endColumn();
        int toOld = old(row, firstColumn()) - cell;
        while (cell < end) {
            int same = Arrays.mismatch(before, cell + toOld, end + toOld, now, cell, end);
            if (same < 0) {
                return;
            }
            cell += same;
            if (CostMap.cost(before[cell + toOld]) != CostMap.cost(now[cell])) {
                add(cell);
            }
            cell++;
        }
    }

    private void addOpen(int row, int firstColumn, int endColumn) {
        for (int column = firstColumn; column < endColumn; column++) {
            if (to.isOpen(row * to.grid().width() + column)) {
                add(row * to.grid().width() + column);
            }
        }
    }

    private void add(int cell) {
        if (count == cells.length) {
            cells = Arrays.copyOf(cells, 2 * count);
        }
        cells[count++] = cell;
    }

    private int old(int row, int column) {
        return (row - rows) * from.grid().width() + column - columns;
    }

    // where the maps lie on each other, in rows and columns of the new one
    private int firstRow() {
        return Math.max(0, rows);
    }

    private int endRow() {
        return Math.min(to.grid().height(), from.grid().height() + rows);
    }

    private int firstColumn() {
        return Math.max(0, columns);
    }

    private int endColumn() {
        return Math.min(to.grid().width(), from.grid().width() + columns);
    }
}
