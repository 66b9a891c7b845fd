package rsal.scenario.run;

import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// The walls of a map: all that is occupied.
final class Walls {
    private final OccupancyGrid map;

    Walls(OccupancyGrid map) {
        this.map = map;
    }

    /// Whether the straight line between two places crosses one; the same in both directions. What lies outside the
    /// map is free of walls.
    boolean standBetween(Point2d one, Point2d other) {
        boolean inOrder = one.x() < other.x() || (one.x() == other.x() && one.y() <= other.y());
        return inOrder ? block(one, other) : block(other, one);
    }

    /// Column by column, all rows that the line passes in each.
    private boolean block(Point2d left, Point2d right) {
        int last = Math.min(map.column(right.x()), map.width() - 1);
        for (int column = Math.max(map.column(left.x()), 0); column <= last; column++) {
            double middle = map.x(column);
            double from = y(left, right, middle - map.resolution() / 2);
            double to = y(left, right, middle + map.resolution() / 2);
            int top = Math.min(map.row(Math.max(from, to)), map.height() - 1);
            for (int row = Math.max(map.row(Math.min(from, to)), 0); row <= top; row++) {
                if (map.at(column, row) == OccupancyGrid.OCCUPIED) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Where the line is at an x, or its end where it does not get there.
    private static double y(Point2d left, Point2d right, double x) {
        if (x <= left.x()) {
            return left.y();
        }
        return x >= right.x() ? right.y() : left.y() + (right.y() - left.y()) * (x - left.x()) / (right.x() - left.x());
    }
}
