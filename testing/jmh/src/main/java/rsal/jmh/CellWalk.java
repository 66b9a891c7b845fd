package rsal.jmh;

import rsal.data.OccupancyGrid;

/// The slow way to find out where a ray ends.
public final class CellWalk {
    private CellWalk() {}

    /// How far the nearest wall is [m], by every cell up to it; +∞ when none is within reach.
    ///
    /// @param dx of the ray's direction, with `dy` a vector of length 1
    /// @param reach [m]
    public static double range(OccupancyGrid map, double x, double y, double dx, double dy, double reach) {
        int column = map.column(x);
        int row = map.row(y);
        int stepColumn = dx > 0 ? 1 : -1;
        int stepRow = dy > 0 ? 1 : -1;
        double perColumn = map.resolution() / Math.abs(dx);
        double perRow = map.resolution() / Math.abs(dy);
        double toColumn = (map.x(column) + stepColumn * map.resolution() / 2 - x) / dx;
        double toRow = (map.y(row) + stepRow * map.resolution() / 2 - y) / dy;
        double distance = 0;
        while (distance <= reach && map.contains(column, row)) {
            if (map.cells()[row * map.width() + column] == OccupancyGrid.OCCUPIED) {
                return distance;
            }
            if (toColumn < toRow) {
                distance = toColumn;
                toColumn += perColumn;
                column += stepColumn;
            } else {
                distance = toRow;
                toRow += perRow;
                row += stepRow;
            }
        }
        return Double.POSITIVE_INFINITY;
    }
}
