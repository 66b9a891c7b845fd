package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.Optional;
import rsal.navigation.grid.CellWindow;
import rsal.navigation.grid.MapOverlay;

/// In which cells one map costs something else than another that lies on the same lattice; each may reach beyond the
/// other, and beyond a map all is blocked.
final class CostChanges {
    /// Of so many cells one may have changed.
    static final int SHARE = 20;

    private final CostMap from;
    private final CostMap to;
    private final MapOverlay overlay;
    private int[] cells = new int[256];
    private int count;

    private CostChanges(CostMap from, CostMap to, MapOverlay overlay) {
        this.from = from;
        this.to = to;
        this.overlay = overlay;
    }

    /// Empty when more than one of [#SHARE] cells has changed, or the maps' cells do not lie on each other.
    static Optional<CostChanges> between(CostMap from, CostMap to) {
        return MapOverlay.of(from.grid(), to.grid())
                .map(overlay -> new CostChanges(from, to, overlay))
                .filter(CostChanges::compare);
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

    /// How the new map lies on the old one.
    MapOverlay overlay() {
        return overlay;
    }

    /// @return whether they are few; else it has stopped
    private boolean compare() {
        CellWindow shared = overlay.shared();
        int width = to.grid().width();
        int most = to.ground().length / SHARE;
        for (int row = 0; row < to.grid().height() && count <= most; row++) {
            if (row < shared.firstRow() || row >= shared.endRow()) {
                addOpen(row, 0, width);
            } else {
                addOpen(row, 0, shared.firstColumn());
                compare(row);
                addOpen(row, shared.endColumn(), width);
            }
        }
        cells = Arrays.copyOf(cells, count);
        return count <= most;
    }

    private void compare(int row) {
        byte[] before = from.ground();
        byte[] now = to.ground();
        overlay.eachMismatch(row, before, now, (old, cell) -> {
            if (CostMap.cost(before[old]) != CostMap.cost(now[cell])) {
                add(cell);
            }
        });
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
}
