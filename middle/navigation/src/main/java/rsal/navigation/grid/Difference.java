package rsal.navigation.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;

/// Where a map differs from one from before in what is free: a few windows, such that whatever is computed from what
/// is free nearby need be computed again near them only. What only one of the maps has counts as different, too.
public final class Difference {
    private static final int NEAR = 32; // cells around windows that are looked at as well, more or less
    private static final int SHARE = 2; // of so many cells one may be looked at
    private static final int MOST_WINDOWS = 64; // each makes it slower to compare

    private final MapOverlay overlay;
    private final List<CellWindow> windows = new ArrayList<>();
    private final long most;
    private long area; // of the windows with what is near

    private Difference(MapOverlay overlay) {
        this.overlay = overlay;
        this.most = most(overlay.now());
    }

    /// Empty when so much differs that all is better computed again, or the maps' cells do not lie on each other.
    public static Optional<Difference> between(OccupancyGrid before, OccupancyGrid now) {
        return MapOverlay.of(before, now).map(Difference::new).filter(Difference::compare);
    }

    /// How many cells of a map may be looked at before it is better to look at all.
    public static long most(OccupancyGrid map) {
        return CellWindow.of(map).area() / SHARE;
    }

    public MapOverlay overlay() {
        return overlay;
    }

    public OccupancyGrid now() {
        return overlay.now();
    }

    /// In columns and rows of the map of now; also beyond it, where the map from before reached farther.
    public List<CellWindow> windows() {
        return windows;
    }

    /// @return whether that is not too much; else it has stopped
    private boolean compare() {
        CellWindow shared = overlay.shared();
        addBeside(shared, CellWindow.of(overlay.now()));
        addBeside(shared, overlay.old());
        for (int row = shared.firstRow(); row < shared.endRow() && !isTooMuch(); row++) {
            compare(row);
        }
        return !isTooMuch();
    }

    private boolean isTooMuch() {
        return area > most || windows.size() > MOST_WINDOWS;
    }

    /// Adds what one of the maps has on the four sides of what both have.
    private void addBeside(CellWindow shared, CellWindow map) {
        addUnlessEmpty(new CellWindow(map.firstColumn(), map.firstRow(), shared.firstColumn(), map.endRow()));
        addUnlessEmpty(new CellWindow(shared.endColumn(), map.firstRow(), map.endColumn(), map.endRow()));
        addUnlessEmpty(new CellWindow(map.firstColumn(), map.firstRow(), map.endColumn(), shared.firstRow()));
        addUnlessEmpty(new CellWindow(map.firstColumn(), shared.endRow(), map.endColumn(), map.endRow()));
    }

    private void addUnlessEmpty(CellWindow window) {
        if (!window.isEmpty()) {
            add(window);
        }
    }

    private void compare(int row) {
        byte[] before = overlay.before().cells();
        byte[] now = overlay.now().cells();
        int first = row * overlay.now().width();
        overlay.eachMismatch(row, before, now, (old, cell) -> {
            if ((before[old] == OccupancyGrid.FREE) != (now[cell] == OccupancyGrid.FREE)) {
                add(cell - first, row);
            }
        });
    }

    private void add(int column, int row) {
        if (!isTooMuch() && !isWithinOne(column, row)) {
            add(new CellWindow(column, row, column + 1, row + 1));
        }
    }

    private boolean isWithinOne(int column, int row) {
        for (int i = windows.size() - 1; i >= 0; i--) {
            if (windows.get(i).contains(column, row)) {
                windows.add(windows.remove(i)); // the next cell is likely to be in it, too
                return true;
            }
        }
        return false;
    }

    /// Joins it with those with which that is no dearer than to look at both.
    private void add(CellWindow window) {
        CellWindow joined = window;
        for (int i = 0; i < windows.size() && !isTooMuch(); i++) {
            CellWindow other = windows.get(i);
            if (withNear(joined.with(other)) <= withNear(joined) + withNear(other)) {
                joined = joined.with(other);
                area -= withNear(windows.remove(i));
                i = -1; // what is larger now may be joined with others
            }
        }
        windows.add(joined);
        area += withNear(joined);
    }

    private long withNear(CellWindow window) {
        return window.grown(NEAR).within(CellWindow.of(overlay.now())).area();
    }
}
