package rsal.navigation.explore;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// Finds frontiers: B. Yamauchi, A Frontier-Based Approach for Autonomous Exploration (CIRA 1997), where it
/// tells how frontiers are detected: open cells beside unknown ones, those that touch each other grouped, small
/// groups left out.
///
/// Differs from the paper in these points:
/// * Cells are open or unknown as the map says; the paper compares their probabilities with that of before.
/// * Long frontiers are cut into pieces, so that robots may share them and the middle of a bent one is not far
///   from it.
/// * The place to go to is the cell nearest to the centroid, as that may lie anywhere when a frontier bends.
/// * Which one to go to is not said here: the paper goes to the nearest, for several robots see
///   [FrontierAssignment].
public final class Frontiers {
    private static final double LONGEST = 3; // m; a piece

    private Frontiers() {}

    /// @param shortest what is shorter is left out: gaps between beams, in meters
    /// @return in the order of their first cells, row by row from the lower left one
    public static List<Frontier> of(OccupancyGrid map, double shortest) {
        var frontier = new BitSet(map.width() * map.height());
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                if (map.at(column, row) == OccupancyGrid.FREE && besideUnknown(map, column, row)) {
                    frontier.set(row * map.width() + column);
                }
            }
        }
        var found = new ArrayList<Frontier>();
        int most = Math.max(1, (int) (LONGEST / map.resolution()));
        for (int first = frontier.nextSetBit(0); first >= 0; first = frontier.nextSetBit(first)) {
            List<Integer> cells = piece(map, frontier, first, most);
            if (cells.size() * map.resolution() >= shortest) {
                found.add(new Frontier(middle(map, cells), cells.size() * map.resolution()));
            }
        }
        return found;
    }

    /// What lies beyond the map is unknown, too.
    private static boolean besideUnknown(OccupancyGrid map, int column, int row) {
        return map.at(column + 1, row) == OccupancyGrid.UNKNOWN
                || map.at(column - 1, row) == OccupancyGrid.UNKNOWN
                || map.at(column, row + 1) == OccupancyGrid.UNKNOWN
                || map.at(column, row - 1) == OccupancyGrid.UNKNOWN;
    }

    /// Takes cells that touch each other, nearest to the first one first.
    private static List<Integer> piece(OccupancyGrid map, BitSet frontier, int first, int most) {
        var cells = new ArrayList<Integer>();
        cells.add(first);
        frontier.clear(first);
        for (int next = 0; next < cells.size(); next++) {
            int column = cells.get(next) % map.width();
            int row = cells.get(next) / map.width();
            for (int r = Math.max(0, row - 1); r <= Math.min(map.height() - 1, row + 1); r++) {
                for (int c = Math.max(0, column - 1); c <= Math.min(map.width() - 1, column + 1); c++) {
                    int cell = r * map.width() + c;
                    if (cells.size() < most && frontier.get(cell)) {
                        frontier.clear(cell);
                        cells.add(cell);
                    }
                }
            }
        }
        return cells;
    }

    private static Point2d middle(OccupancyGrid map, List<Integer> cells) {
        double x = 0;
        double y = 0;
        for (int cell : cells) {
            x += map.x(cell % map.width()) / cells.size();
            y += map.y(cell / map.width()) / cells.size();
        }
        var middle = new Point2d(x, y);
        Point2d nearest = middle;
        double least = Double.POSITIVE_INFINITY;
        for (int cell : cells) {
            Point2d place = map.middle(cell);
            if (place.distanceTo(middle) < least) {
                least = place.distanceTo(middle);
                nearest = place;
            }
        }
        return nearest;
    }
}
