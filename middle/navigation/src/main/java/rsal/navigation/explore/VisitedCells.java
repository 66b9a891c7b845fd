package rsal.navigation.explore;

import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// Where a robot stands is free, though no laser sees it there: without that, one whose laser doesn't look back
/// begins at the rim of what is known, with no room to turn.
public final class VisitedCells {
    private VisitedCells() {}

    /// @param places where robots stood
    /// @param radius of what is free around them [m]; what was hit there stays
    /// @return a map of its own
    public static OccupancyGrid free(OccupancyGrid map, List<Point2d> places, double radius) {
        byte[] cells = map.cells().clone();
        for (Point2d place : places) {
            int firstRow = Math.max(0, map.row(place.y() - radius));
            int lastRow = Math.min(map.height() - 1, map.row(place.y() + radius));
            int firstColumn = Math.max(0, map.column(place.x() - radius));
            int lastColumn = Math.min(map.width() - 1, map.column(place.x() + radius));
            for (int row = firstRow; row <= lastRow; row++) {
                for (int column = firstColumn; column <= lastColumn; column++) {
                    int cell = row * map.width() + column;
                    if (cells[cell] == OccupancyGrid.UNKNOWN && map.middle(cell).distanceTo(place) <= radius) {
                        cells[cell] = OccupancyGrid.FREE;
                    }
                }
            }
        }
        return new OccupancyGrid(map.width(), map.height(), map.resolution(), map.originX(), map.originY(), cells);
    }
}
