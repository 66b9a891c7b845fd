package rsal.data;

/// The walls of a map: all that is occupied.
public final class Walls {
    private final OccupancyGrid map;

    public Walls(OccupancyGrid map) {
        this.map = map;
    }

    /// Whether the straight line between two places crosses one; the same in both directions. What lies outside the
    /// map is free of walls.
    public boolean standBetween(Point2d one, Point2d other) {
        boolean inOrder = one.x() < other.x() || (one.x() == other.x() && one.y() <= other.y());
        return inOrder ? block(one, other) : block(other, one);
    }

    /// Whether walls hide all of a body: its middle, and what is so far to the left and to the right of it, as
    /// seen from a place.
    ///
    /// @param side how far to each side [m]
    public boolean hide(Point2d from, Point2d middle, double side) {
        double distance = from.distanceTo(middle);
        if (!standBetween(from, middle)) {
            return false;
        }
        if (distance == 0) {
            return true;
        }
        double x = -(middle.y() - from.y()) / distance * side;
        double y = (middle.x() - from.x()) / distance * side;
        return standBetween(from, new Point2d(middle.x() + x, middle.y() + y))
                && standBetween(from, new Point2d(middle.x() - x, middle.y() - y));
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
