package rsal.navigation.spread;

import java.util.Arrays;
import java.util.OptionalInt;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;

/// The parts of a map between which no way leads with some clearance.
final class Parts {
    static final int NONE = -1;
    private static final int ANY = -2;

    private final OccupancyGrid map;
    private final double clearance;
    private final DistanceField toNotFree;
    private final CostMap open;
    private final int[] partOf;
    private int[] sizes = new int[16];
    private int count;

    /// @param clearance [m]
    Parts(OccupancyGrid given, double clearance) {
        if (!(clearance >= 0 && clearance < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "The clearance (%s) must be a distance of at least 0 m. Maybe the robot's radius was meant."
                            .formatted(clearance));
        }
        this.map = rimUnknown(given);
        this.clearance = clearance;
        this.toNotFree = DistanceField.toNotFree(map);
        this.open = CostMap.of(map, toNotFree, new Clearance(clearance, clearance, 0));
        this.partOf = new int[map.cells().length];
        Arrays.fill(partOf, NONE);
        var queue = new int[partOf.length];
        for (int cell = 0; cell < partOf.length; cell++) {
            if (partOf[cell] == NONE && open.isOpen(cell)) {
                if (count == sizes.length) {
                    sizes = Arrays.copyOf(sizes, 2 * count);
                }
                sizes[count] = fill(cell, queue);
                count++;
            }
        }
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

    /// Gives all cells that are connected along sides with one its part, and says how many they are. The outermost
    /// cells are never open, so that each has four neighbors.
    private int fill(int first, int[] queue) {
        int end = 0;
        partOf[first] = count;
        queue[end++] = first;
        for (int next = 0; next < end; next++) {
            int cell = queue[next];
            for (int side = 0; side < 4; side++) {
                int neighbor = cell
                        + switch (side) {
                            case 0 -> 1;
                            case 1 -> -1;
                            case 2 -> map.width();
                            default -> -map.width();
                        };
                if (partOf[neighbor] == NONE && open.isOpen(neighbor)) {
                    partOf[neighbor] = count;
                    queue[end++] = neighbor;
                }
            }
        }
        return end;
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
        return count;
    }

    /// How many cells a part has.
    int size(int part) {
        return sizes[part];
    }

    /// The one with most cells, of several the first by rows; [#NONE] when the robot can be nowhere.
    int largest() {
        int largest = NONE;
        for (int part = 0; part < count; part++) {
            largest = largest == NONE || sizes[part] > sizes[largest] ? part : largest;
        }
        return largest;
    }

    /// The part that a place is in, or [#NONE].
    int of(Point2d place) {
        int column = map.column(place.x());
        int row = map.row(place.y());
        return map.contains(column, row) ? partOf[row * map.width() + column] : NONE;
    }

    /// The part of the nearest place within a distance [m] in which a robot can be, or [#NONE].
    int nearest(Point2d place, double within) {
        OptionalInt nearest = nearest(place, within, ANY);
        return nearest.isPresent() ? partOf[nearest.getAsInt()] : NONE;
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
                boolean counts = wanted == ANY ? partOf[cell] != NONE : partOf[cell] == wanted;
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
        var cells = new int[sizes[part]];
        int next = 0;
        for (int cell = 0; next < cells.length; cell++) {
            if (partOf[cell] == part) {
                cells[next++] = cell;
            }
        }
        return cells;
    }

    boolean isIn(int cell, int part) {
        return partOf[cell] == part;
    }
}
