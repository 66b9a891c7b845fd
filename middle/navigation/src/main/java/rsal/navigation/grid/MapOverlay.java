package rsal.navigation.grid;

import java.util.Arrays;
import java.util.Optional;
import rsal.data.OccupancyGrid;

/// How a map lies on one from before whose cells are on the same lattice; either may reach beyond the other.
///
/// @param columns by which a cell's column is larger in the map of now
/// @param rows the same
public record MapOverlay(OccupancyGrid before, OccupancyGrid now, int columns, int rows) {
    private static final double ALIGNED = 1e-6; // of a cell

    /// Takes the numbers that a cell has in the map from before and in that of now.
    public interface CellVisitor {
        void visit(int before, int now);
    }

    /// Empty when the maps' cells do not lie on each other, or no cell is in both.
    public static Optional<MapOverlay> of(OccupancyGrid before, OccupancyGrid now) {
        double columns = (before.originX() - now.originX()) / now.resolution();
        double rows = (before.originY() - now.originY()) / now.resolution();
        boolean isAligned = before.resolution() == now.resolution()
                && Math.abs(columns - Math.rint(columns)) < ALIGNED
                && Math.abs(rows - Math.rint(rows)) < ALIGNED
                && Math.abs(columns) < now.width() + before.width() // else the numbers may be too large
                && Math.abs(rows) < now.height() + before.height();
        return isAligned
                ? Optional.of(new MapOverlay(before, now, (int) Math.rint(columns), (int) Math.rint(rows)))
                        .filter(overlay -> !overlay.shared().isEmpty())
                : Optional.empty();
    }

    /// Where both are, in the map of now.
    public CellWindow shared() {
        return CellWindow.of(now).within(old());
    }

    /// Where that from before is, in columns and rows of that of now.
    CellWindow old() {
        return new CellWindow(columns, rows, columns + before.width(), rows + before.height());
    }

    public boolean isSameSize() {
        return columns == 0 && rows == 0 && before.width() == now.width() && before.height() == now.height();
    }

    /// The number that a cell of the map of now has in that from before, where that is.
    public int old(int column, int row) {
        return (row - rows) * before.width() + column - columns;
    }

    /// The number that a cell of the map from before has in that of now; −1 when it lies beyond that.
    public int moved(int cell) {
        int column = cell % before.width() + columns;
        int row = cell / before.width() + rows;
        return now.contains(column, row) ? row * now.width() + column : -1;
    }

    /// Visits the cells of a row where both maps are that hold one thing before and another now, from left to right.
    ///
    /// @param row of the map of now
    /// @param before what cells of the map from before hold
    /// @param now the same
    public void eachMismatch(int row, byte[] before, byte[] now, CellVisitor visitor) {
        CellWindow shared = shared();
        int cell = row * now().width() + shared.firstColumn();
        int end = cell + shared.width();
        int toOld = old(shared.firstColumn(), row) - cell;
        while (cell < end) {
            int same = Arrays.mismatch(before, cell + toOld, end + toOld, now, cell, end);
            if (same < 0) {
                return;
            }
            cell += same;
            visitor.visit(cell + toOld, cell);
            cell++;
        }
    }

    /// What cells of the map from before hold, in those of the map of now; 0 in what lies beyond.
    public float[] moved(float[] field) {
        return isSameSize() ? field.clone() : copied(field, new float[now.cells().length]);
    }

    /// The same.
    public byte[] moved(byte[] field) {
        return isSameSize() ? field.clone() : copied(field, new byte[now.cells().length]);
    }

    /// The same.
    public int[] moved(int[] field) {
        return copied(field, new int[now.cells().length]);
    }

    /// @return `to`
    private <A> A copied(A from, A to) {
        CellWindow shared = shared();
        for (int row = shared.firstRow(); row < shared.endRow(); row++) {
            int start = row * now.width() + shared.firstColumn();
            System.arraycopy(from, old(shared.firstColumn(), row), to, start, shared.width());
        }
        return to;
    }
}
