package rsal.navigation.spread;

import java.util.OptionalInt;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.OpenParts;

/// The parts of a map between which no way leads with some clearance.
final class ConnectedComponents {
    static final int NONE = OpenParts.NONE;
    private static final int ANY = -2;

    private final OccupancyGrid map;
    private final double clearance;
    private final DistanceField toNotFree;
    private final CostMap open;
    private final OpenParts parts;

    /// @param clearance [m]
    ConnectedComponents(OccupancyGrid given, double clearance) {
        if (!(clearance >= 0 && clearance < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "The clearance '%s' must be a distance of at least 0 m. Maybe the robot's radius was meant."
                            .formatted(clearance));
        }
        this.map = rimUnknown(given);
        this.clearance = clearance;
        this.toNotFree = DistanceField.toNotFree(map);
        this.open = CostMap.of(map, toNotFree, new Clearance(clearance, clearance, 0));
        this.parts = new OpenParts(open);
    }

    /// The same map, of whose outermost cells nothing is known: nobody knows what lies beyond, either.
    private static OccupancyGrid rimUnknown(OccupancyGrid map) {
        byte[] cells = map.cells().clone();
        int width = map.width();
        int top = cells.length - width;
        for (int column = 0; column < width; column++) {
            cells[column] = unlessOccupied(cells[column]);
            cells[top + column] = unlessOccupied(cells[top + column]);
        }
        for (int left = 0; left < cells.length; left += width) {
            cells[left] = unlessOccupied(cells[left]);
            cells[left + width - 1] = unlessOccupied(cells[left + width - 1]);
        }
        return new OccupancyGrid(width, map.height(), map.resolution(), map.originX(), map.originY(), cells);
    }

    private static byte unlessOccupied(byte value) {
        return value == OccupancyGrid.OCCUPIED ? value : OccupancyGrid.UNKNOWN;
    }

    OccupancyGrid map() {
        return map;
    }

    double clearance() {
        return clearance;
    }

    DistanceField toNotFree() {
        return toNotFree;
    }

    CostMap open() {
        return open;
    }

    int count() {
        return parts.count();
    }

    /// How many cells a part has.
    int size(int part) {
        return parts.size(part);
    }

    /// The one with most cells, of several the first by rows; [#NONE] when the robot can be nowhere.
    int largest() {
        int largest = NONE;
        for (int part = 0; part < count(); part++) {
            largest = largest == NONE || size(part) > size(largest) ? part : largest;
        }
        return largest;
    }

    /// The part that a place is in, or [#NONE].
    int of(Point2d place) {
        int column = map.column(place.x());
        int row = map.row(place.y());
        return map.contains(column, row) ? parts.of(row * map.width() + column) : NONE;
    }

    /// The part of the nearest place within a distance [m] in which a robot can be, or [#NONE].
    int nearest(Point2d place, double within) {
        OptionalInt nearest = nearest(place, within, ANY);
        return nearest.isPresent() ? parts.of(nearest.getAsInt()) : NONE;
    }

    /// The cell of a part that is nearest to a place, within a distance [m].
    OptionalInt nearest(Point2d place, double within, int wanted) {
        int column = map.column(place.x());
        int row = map.row(place.y());
        int reach = (int) Math.ceil(within / map.resolution());
        int nearest = NONE;
        double least = within;
        for (int r = Math.max(0, row - reach); r <= Math.min(map.height() - 1, row + reach); r++) {
            for (int c = Math.max(0, column - reach); c <= Math.min(map.width() - 1, column + reach); c++) {
                double distance = Math.hypot(map.x(c) - place.x(), map.y(r) - place.y());
                int cell = r * map.width() + c;
                boolean counts = wanted == ANY ? parts.of(cell) != NONE : parts.of(cell) == wanted;
                if (counts && (distance < least || (nearest == NONE && distance <= least))) {
                    least = distance;
                    nearest = cell;
                }
            }
        }
        return nearest == NONE ? OptionalInt.empty() : OptionalInt.of(nearest);
    }

    /// The cells of a part, row by row.
    int[] cells(int part) {
        var cells = new int[size(part)];
        int next = 0;
        for (int cell = 0; next < cells.length; cell++) {
            if (parts.of(cell) == part) {
                cells[next++] = cell;
            }
        }
        return cells;
    }

    boolean isIn(int cell, int part) {
        return parts.of(cell) == part;
    }
}
