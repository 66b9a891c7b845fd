package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.CellWindow;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap.Clearance;

/// Computes the ground of a [CostMap], of all of a map or of windows in one that has changed.
final class CostComputation {
    private final OccupancyGrid grid;
    private final DistanceField toNotFree;
    private final Clearance clearance;
    private final byte[] ground;
    private final int width;

    private CostComputation(OccupancyGrid grid, DistanceField toNotFree, Clearance clearance, byte[] ground) {
        this.grid = grid;
        this.toNotFree = toNotFree;
        this.clearance = clearance;
        this.ground = ground;
        this.width = grid.width();
    }

    /// All of a map's.
    ///
    /// @param driven as [CostMap#of] has it
    static byte[] all(OccupancyGrid grid, DistanceField toNotFree, Clearance clearance, List<List<Point2d>> driven) {
        var ground = new byte[grid.cells().length];
        new CostComputation(grid, toNotFree, clearance, ground).compute(List.of(CellWindow.of(grid)), driven);
        return ground;
    }

    /// The same where only windows need to be computed.
    ///
    /// @param ground written to in these
    static void within(
            List<CellWindow> windows, OccupancyGrid grid, DistanceField toNotFree, Clearance clearance, byte[] ground) {
        new CostComputation(grid, toNotFree, clearance, ground).compute(windows, List.of());
    }

    private void compute(List<CellWindow> windows, List<List<Point2d>> driven) {
        windows.forEach(this::compute);
        blockRim();
        for (List<Point2d> path : driven) {
            for (int i = 1; i < path.size(); i++) {
                open(path.get(i - 1), path.get(i));
            }
        }
        for (CellWindow window : windows) {
            markPlains(window.grown(1).within(CellWindow.of(grid).grown(-1)));
        }
    }

    private void compute(CellWindow window) {
        double halfCell = grid.resolution() / 2; // from the middle of the obstacle's cell to its side
        for (int row = window.firstRow(); row < window.endRow(); row++) {
            int end = row * width + window.endColumn();
            for (int cell = row * width + window.firstColumn(); cell < end; cell++) {
                double distance = toNotFree.at(cell) - halfCell;
                boolean isOpen = distance > 0 && distance >= clearance.radius();
                ground[cell] = isOpen ? (byte) clearance.cost(distance) : CostMap.BLOCKED;
            }
        }
    }

    private void blockRim() {
        Arrays.fill(ground, 0, width, CostMap.BLOCKED);
        Arrays.fill(ground, ground.length - width, ground.length, CostMap.BLOCKED);
        for (int row = 0; row < ground.length; row += width) {
            ground[row] = CostMap.BLOCKED;
            ground[row + width - 1] = CostMap.BLOCKED;
        }
    }

    /// Opens the free cells on a straight piece of way, and of each two that touch at a corner only, one beside them.
    private void open(Point2d from, Point2d to) {
        int samples = Math.max(1, (int) Math.ceil(4 * from.distanceTo(to) / grid.resolution()));
        int row = grid.row(from.y());
        for (int i = 0; i <= samples; i++) {
            double share = (double) i / samples;
            int nextColumn = grid.column(from.x() + share * (to.x() - from.x()));
            int nextRow = grid.row(from.y() + share * (to.y() - from.y()));
            open(nextColumn, row);
            open(nextColumn, nextRow);
            row = nextRow;
        }
    }

    private void open(int column, int row) {
        boolean inside = column > 0 && row > 0 && column < width - 1 && row < grid.height() - 1;
        int cell = row * width + column;
        if (inside && ground[cell] == CostMap.BLOCKED && grid.cells()[cell] == OccupancyGrid.FREE) {
            ground[cell] = (byte) clearance.cost(clearance.radius());
        }
    }

    /// @param window of which all cells are plain or not from now on, none of them on the rim of the map
    private void markPlains(CellWindow window) {
        for (int row = window.firstRow(); row < window.endRow(); row++) {
            int first = row * width + window.firstColumn();
            int end = row * width + window.endColumn();
            int cheap = 0; // columns in a row whose three cells cost least
            for (int cell = first - 1; cell <= end; cell++) {
                cheap = isCheap(cell - width) && isCheap(cell) && isCheap(cell + width) ? cheap + 1 : 0;
                if (cheap >= 3) {
                    ground[cell - 1] = CostMap.PLAIN;
                } else if (cell > first && ground[cell - 1] == CostMap.PLAIN) {
                    ground[cell - 1] = CostMap.STRAIGHT;
                }
            }
        }
    }

    private boolean isCheap(int cell) {
        return CostMap.cost(ground[cell]) == CostMap.STRAIGHT;
    }
}
