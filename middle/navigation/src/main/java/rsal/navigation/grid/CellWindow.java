package rsal.navigation.grid;

import rsal.data.OccupancyGrid;

/// A rectangle of cells of a map, which may reach beyond it.
///
/// @param endColumn first one behind it
/// @param endRow the same
public record CellWindow(int firstColumn, int firstRow, int endColumn, int endRow) {
    /// All of a map.
    public static CellWindow of(OccupancyGrid map) {
        return new CellWindow(0, 0, map.width(), map.height());
    }

    public boolean isEmpty() {
        return firstColumn >= endColumn || firstRow >= endRow;
    }

    /// Columns.
    public int width() {
        return endColumn - firstColumn;
    }

    /// Rows.
    public int height() {
        return endRow - firstRow;
    }

    /// Cells, of one that is not empty.
    public long area() {
        return (long) width() * height();
    }

    public boolean contains(int column, int row) {
        return column >= firstColumn && column < endColumn && row >= firstRow && row < endRow;
    }

    /// Larger by some cells on each side.
    public CellWindow grown(int cells) {
        return new CellWindow(firstColumn - cells, firstRow - cells, endColumn + cells, endRow + cells);
    }

    /// What both have; empty where that is nothing.
    public CellWindow within(CellWindow other) {
        return new CellWindow(
                Math.max(firstColumn, other.firstColumn),
                Math.max(firstRow, other.firstRow),
                Math.min(endColumn, other.endColumn),
                Math.min(endRow, other.endRow));
    }

    /// The least that contains both.
    CellWindow with(CellWindow other) {
        return new CellWindow(
                Math.min(firstColumn, other.firstColumn),
                Math.min(firstRow, other.firstRow),
                Math.max(endColumn, other.endColumn),
                Math.max(endRow, other.endRow));
    }
}
