package rsal.navigation.passage;

import java.util.Arrays;
import java.util.function.IntPredicate;

/// For each cell where a robot can be, the distance to the nearest wide place along cells where it can be, and the
/// cell before it on the path from there. Steps cost 5 along sides and 7 across corners (Borgefors 1986, chamfer 5-7).
final class WideFlood {
    static final int STEP = 5;
    private static final int CORNER = 7;
    private static final int[] COLUMNS = {1, -1, 0, 0, 1, 1, -1, -1};
    private static final int[] ROWS = {0, 0, 1, -1, 1, -1, 1, -1};

    private final int width;
    private final int[] distances;
    private final int[] sources;
    private final int[] parents;

    /// @param isOpen where the robot can be; never on the rim of the map
    /// @param isWide where two can pass
    WideFlood(int width, int height, IntPredicate isOpen, IntPredicate isWide) {
        this.width = width;
        int cells = width * height;
        this.distances = new int[cells];
        this.sources = new int[cells];
        this.parents = new int[cells];
        Arrays.fill(distances, Integer.MAX_VALUE);
        Arrays.fill(sources, -1);
        Arrays.fill(parents, -1);
        var buckets = new IntList[CORNER + 1];
        Arrays.setAll(buckets, _ -> new IntList());
        for (int cell = 0; cell < cells; cell++) {
            if (isOpen.test(cell) && isWide.test(cell)) {
                distances[cell] = 0;
                sources[cell] = cell;
                buckets[0].add(cell);
            }
        }
        spread(buckets, isOpen);
    }

    private void spread(IntList[] buckets, IntPredicate isOpen) {
        int empty = 0;
        for (int distance = 0; empty <= CORNER; distance++) {
            IntList now = buckets[distance % buckets.length];
            empty = now.size() == 0 ? empty + 1 : 0;
            for (int i = 0; i < now.size(); i++) {
                int cell = now.get(i);
                if (distances[cell] == distance) {
                    step(cell, distance, buckets, isOpen);
                }
            }
            now.clear();
        }
    }

    private void step(int cell, int distance, IntList[] buckets, IntPredicate isOpen) {
        for (int side = 0; side < 8; side++) {
            int next = neighbor(cell, side);
            int far = distance + (side < 4 ? STEP : CORNER);
            if (far < distances[next] && isOpen.test(next)) {
                distances[next] = far;
                sources[next] = sources[cell];
                parents[next] = cell;
                buckets[far % buckets.length].add(next);
            }
        }
    }

    /// @param side 0 to 3 along sides, 4 to 7 across corners
    int neighbor(int cell, int side) {
        return cell + ROWS[side] * width + COLUMNS[side];
    }

    /// In fifths of a cell; the greatest number where no path leads.
    int distance(int cell) {
        return distances[cell];
    }

    /// The wide cell that is nearest; -1 where no path leads.
    int source(int cell) {
        return sources[cell];
    }

    /// The cell before it on the path from there; -1 for a wide one.
    int parent(int cell) {
        return parents[cell];
    }

    boolean isReached(int cell) {
        return sources[cell] >= 0;
    }
}
