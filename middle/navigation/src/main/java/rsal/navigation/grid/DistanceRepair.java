package rsal.navigation.grid;

import java.util.ArrayList;
import java.util.Optional;
import rsal.data.DistanceTransform;
import rsal.data.OccupancyGrid;

/// Takes distances to the nearest cell that is not free over from one map to another.
///
/// What has changed concerns a cell only if it is no farther off than what the cell was measured to before. So a window
/// grows by some reach around it until no cell on its rim was measured to anything that far off. No cell beyond is
/// concerned then: the straight line from there to the change crosses the rim, and what cells are measured to grows by
/// no more than the way from one to the other. The window is measured with as much around it again, and what is found
/// within the reach is the nearest; otherwise the reach is doubled.
///
/// The dynamic transform of B. Lau, C. Sprunk, W. Burgard (Efficient Grid-Based Spatial Representations for Robot
/// Navigation in Dynamic Environments, Robotics and Autonomous Systems 61, 2013) looks at cells that are concerned
/// only, but passes the nearest one on from cell to cell, which is not always exact; this is, to the bit.
final class DistanceRepair {
    private static final int FIRST_REACH = 16; // cells; doubled until it is enough

    private final Difference difference;
    private final OccupancyGrid map;
    private final CellWindow all;
    private final float[] before;
    private long looked; // at so many cells

    /// What has changed, and how far around it cells are measured, with as much around them again.
    ///
    /// @param reach cells
    private record Part(CellWindow changed, int reach) {
        CellWindow measured(CellWindow all) {
            return changed.grown(reach).within(all);
        }

        CellWindow around(CellWindow all) {
            return changed.grown(2 * reach).within(all);
        }

        Part doubled() {
            return new Part(changed, 2 * reach);
        }
    }

    DistanceRepair(Difference difference, float[] before) {
        this.difference = difference;
        this.map = difference.now();
        this.all = CellWindow.of(map);
        this.before = before;
    }

    /// By cell of the map of now [m]; empty where to measure all is no dearer.
    Optional<float[]> meters() {
        var parts = new ArrayList<Part>();
        for (CellWindow window : difference.windows()) {
            Part part = upToUnconcerned(new Part(window, FIRST_REACH));
            if (isTooMuch(part)) {
                return Optional.empty();
            }
            parts.add(part);
        }
        float[] meters = difference.overlay().moved(before);
        for (Part first : parts) {
            Part part = first;
            while (!isMeasured(part, meters)) {
                part = upToUnconcerned(part.doubled());
                if (isTooMuch(part)) {
                    return Optional.empty();
                }
            }
        }
        return Optional.of(meters);
    }

    /// Counts what is looked at for a part.
    private boolean isTooMuch(Part part) {
        looked += part.around(all).area();
        return looked > Difference.most(map);
    }

    /// With the least reach beyond which no cell is concerned.
    private Part upToUnconcerned(Part first) {
        Part part = first;
        while (!isUnconcernedBeyond(part.changed().grown(part.reach()), (part.reach() - 1) * map.resolution())) {
            part = part.doubled();
        }
        return part;
    }

    /// Whether no cell on the rim of a window was measured to anything as far off as said [m].
    private boolean isUnconcernedBeyond(CellWindow window, double distance) {
        for (int column = window.firstColumn(); column < window.endColumn(); column++) {
            if (!isNearer(column, window.firstRow(), distance) || !isNearer(column, window.endRow() - 1, distance)) {
                return false;
            }
        }
        for (int row = window.firstRow(); row < window.endRow(); row++) {
            if (!isNearer(window.firstColumn(), row, distance) || !isNearer(window.endColumn() - 1, row, distance)) {
                return false;
            }
        }
        return true;
    }

    /// Whether a cell was measured to something nearer, or not at all.
    private boolean isNearer(int column, int row, double distance) {
        MapOverlay overlay = difference.overlay();
        return !overlay.old().contains(column, row) || before[overlay.old(column, row)] < distance;
    }

    /// @param meters written to
    /// @return whether nothing farther off can be nearer
    private boolean isMeasured(Part part, float[] meters) {
        CellWindow window = part.measured(all);
        CellWindow around = part.around(all);
        byte[] cells = map.cells();
        int first = around.firstRow() * map.width() + around.firstColumn();
        int width = around.width();
        int skipped = window.firstColumn() - around.firstColumn();
        DistanceTransform.measure(
                width,
                around.height(),
                cell -> cells[first + cell / width * map.width() + cell % width] != OccupancyGrid.FREE,
                (row, squares) -> {
                    int mapRow = row + around.firstRow();
                    if (mapRow >= window.firstRow() && mapRow < window.endRow()) {
                        int start = mapRow * map.width() + window.firstColumn();
                        for (int column = 0; column < window.width(); column++) {
                            meters[start + column] = DistanceField.meters(map, squares[skipped + column]);
                        }
                    }
                });
        return around.equals(all) || isAllNearer(window, meters, part.reach() * map.resolution());
    }

    private boolean isAllNearer(CellWindow window, float[] meters, double distance) {
        for (int row = window.firstRow(); row < window.endRow(); row++) {
            for (int column = window.firstColumn(); column < window.endColumn(); column++) {
                if (!(meters[row * map.width() + column] < distance)) {
                    return false;
                }
            }
        }
        return true;
    }
}
