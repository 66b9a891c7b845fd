package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.function.IntPredicate;

/// The parts of a map between which no way leads: as ways cut no corners, cells that are connected along sides.
/// Numbered by their first cells, row by row. Immutable.
public final class OpenParts {
    /// Of cells where the robot can't be.
    public static final int NONE = -1;

    private final CostMap map;
    private final IntPredicate isOpen;
    private final int[] partOf;
    private int[] sizes = new int[16];
    private int count;

    public OpenParts(CostMap map) {
        this(map, map::isOpen);
    }

    /// @param isOpen where the robot can be; of the map's open cells none or more are left out
    public OpenParts(CostMap map, IntPredicate isOpen) {
        this.map = map;
        this.isOpen = isOpen;
        this.partOf = new int[map.grid().cells().length];
        Arrays.fill(partOf, NONE);
        var queue = new int[partOf.length];
        for (int cell = 0; cell < partOf.length; cell++) {
            if (partOf[cell] == NONE && isOpen.test(cell)) {
                if (count == sizes.length) {
                    sizes = Arrays.copyOf(sizes, 2 * count);
                }
                sizes[count] = fill(cell, queue);
                count++;
            }
        }
    }

    /// Gives all cells that are connected along sides with one its part, and says how many they are. The outermost
    /// cells are never open, so that each has four neighbors.
    private int fill(int first, int[] queue) {
        int width = map.grid().width();
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
                            case 2 -> width;
                            default -> -width;
                        };
                if (partOf[neighbor] == NONE && isOpen.test(neighbor)) {
                    partOf[neighbor] = count;
                    queue[end++] = neighbor;
                }
            }
        }
        return end;
    }

    public int count() {
        return count;
    }

    /// How many cells a part has.
    public int size(int part) {
        return sizes[part];
    }

    /// The part that a cell is in, or [#NONE].
    public int of(int cell) {
        return partOf[cell];
    }
}
