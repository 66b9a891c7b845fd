package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.CellWindow;
import rsal.navigation.grid.MapOverlay;

/// Finds the cells of a [CostMap] that are blocked beside an open one or across a corner from it.
final class FreeSpaceBoundary {
    private static final int[] NONE = {};

    private final MapOverlay overlay;
    private final int[] before;
    private final byte[] ground;
    private final int width;
    private final byte[] open; // of each column of three rows, whether any is, as what is blocked has no bit
    private int next; // of `before`
    private int[] cells;
    private int count;

    private FreeSpaceBoundary(MapOverlay overlay, int[] before, byte[] ground) {
        this.overlay = overlay;
        this.before = before;
        this.ground = ground;
        this.width = overlay.now().width();
        this.open = new byte[width + 2]; // one more on either side
        this.cells = new int[before.length + width];
    }

    /// Of all of a map, in ascending order.
    static int[] of(OccupancyGrid grid, byte[] ground) {
        return over(new MapOverlay(grid, grid, 0, 0), NONE, ground, List.of(CellWindow.of(grid)));
    }

    /// The same where ground differs from a map before in some windows only, in which is all that this did not have.
    ///
    /// @param before the shore of that
    static int[] over(MapOverlay overlay, int[] before, byte[] ground, List<CellWindow> windows) {
        var shore = new FreeSpaceBoundary(overlay, before, ground);
        List<CellWindow> fromLeft = windows.stream()
                .map(window -> window.grown(1).within(CellWindow.of(overlay.now())))
                .sorted(Comparator.comparingInt(CellWindow::firstColumn))
                .toList();
        for (int row = 0; row < overlay.now().height(); row++) {
            shore.find(row, fromLeft);
        }
        return Arrays.copyOf(shore.cells, shore.count);
    }

    private void find(int row, List<CellWindow> fromLeft) {
        if (count + width > cells.length) {
            cells = Arrays.copyOf(cells, 2 * (count + width));
        }
        int column = 0;
        for (CellWindow window : fromLeft) {
            if (row >= window.firstRow() && row < window.endRow() && window.endColumn() > column) {
                int first = Math.max(column, window.firstColumn());
                takeOver(row, column, first);
                find(row, first, window.endColumn());
                column = window.endColumn();
            }
        }
        takeOver(row, column, width);
    }

    private void takeOver(int row, int firstColumn, int endColumn) {
        if (firstColumn == endColumn) {
            return; // these columns may not have been there before
        }
        int first = overlay.old(firstColumn, row);
        int toNow = row * width + firstColumn - first;
        while (next < before.length && before[next] < first) {
            next++;
        }
        for (; next < before.length && before[next] < first + endColumn - firstColumn; next++) {
            cells[count++] = before[next] + toNow;
        }
    }

    private void find(int row, int firstColumn, int endColumn) {
        int here = row * width;
        int below = Math.max(0, here - width);
        int above = Math.min(ground.length - width, here + width);
        join(ground, below, here, above, Math.max(0, firstColumn - 1), Math.min(width, endColumn + 1), open);
        count = find(ground, here, firstColumn, endColumn, open, cells, count);
    }

    private static void join(byte[] ground, int below, int here, int above, int first, int end, byte[] open) {
        for (int column = first; column < end; column++) {
            open[column + 1] = (byte) (ground[below + column] | ground[here + column] | ground[above + column]);
        }
    }

    /// @return how many there are then
    private static int find(byte[] ground, int here, int first, int end, byte[] open, int[] cells, int count) {
        int more = count;
        for (int column = first; column < end; column++) {
            if (ground[here + column] == CostMap.BLOCKED && (open[column] | open[column + 1] | open[column + 2]) != 0) {
                cells[more++] = here + column;
            }
        }
        return more;
    }
}
