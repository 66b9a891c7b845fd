package rsal.navigation.spread;

import java.util.Arrays;
import rsal.data.OccupancyGrid;

/// A [ReachableSpace] in less detail: the map is cut into square blocks, and what is connected within a block
/// is one patch. Patches are neighbors where their cells are, and as far apart as their middles, so that no
/// door is lost and no wall has a hole, however large the blocks.
///
/// Immutable.
final class Patches {
    /// Lengths of ways are whole numbers of this part of a block's side; its diagonal is one nearly, too.
    static final int FINENESS = 70;

    private final int side; // of a block, in cells
    private final int count;
    private final int[] patchOf;
    private final int[] places;
    private final int[] weights;
    private final boolean[] roomy;
    private final int[] first;
    private final int[] neighbors;
    private final int[] lengths;
    private final int longest;

    /// @param side of a block, in cells
    Patches(ReachableSpace ground, int side) {
        OccupancyGrid map = ground.map();
        int width = map.width();
        var found = new Found(ground, side);
        this.side = side;
        this.count = found.count;
        this.patchOf = found.patchOf;
        this.places = Arrays.copyOf(found.places, count);
        this.weights = Arrays.copyOf(found.weights, count);
        this.roomy = new boolean[count];
        for (int patch = 0; patch < count; patch++) {
            roomy[patch] = ground.isRoomy(places[patch]);
        }
        long[] pairs = pairs(ground, side, width);
        this.first = new int[count + 1];
        this.neighbors = new int[pairs.length];
        this.lengths = new int[pairs.length];
        int most = 1;
        for (int i = 0; i < pairs.length; i++) {
            int from = (int) (pairs[i] >>> 32);
            int to = (int) pairs[i];
            double away = Math.hypot(found.x[from] - found.x[to], found.y[from] - found.y[to]);
            first[from + 1]++;
            neighbors[i] = to;
            lengths[i] = Math.max(1, (int) Math.round(away * FINENESS / side));
            most = Math.max(most, lengths[i]);
        }
        for (int patch = 0; patch < count; patch++) {
            first[patch + 1] += first[patch];
        }
        this.longest = most;
    }

    /// Larger and larger ones until there are few enough. Narrow passages make more of them than the area
    /// lets expect; then each step makes blocks wider by at least one unit, and by an eighth.
    ///
    /// @param first the finest
    /// @param unit what sides of blocks are multiples of, so that blocks consist of whole smaller ones
    /// [cells]; the side of the first is one, too
    static Patches atMost(ReachableSpace ground, Patches first, int unit, int most) {
        Patches patches = first;
        for (int times = first.side / unit; patches.count > most; ) {
            times += Math.max(1, times / 8);
            patches = new Patches(ground, unit * times);
        }
        return patches;
    }

    /// Side of blocks that cut so many cells into about so many pieces [cells].
    static int side(int cells, int pieces) {
        return Math.max(1, (int) Math.sqrt((double) cells / pieces));
    }

    /// Patches while they are found.
    private static final class Found {
        private final int[] patchOf;
        private int count;
        private int[] places = new int[64];
        private int[] weights = new int[64];
        private double[] x = new double[64]; // of middles, in cells
        private double[] y = new double[64];

        Found(ReachableSpace ground, int side) {
            int width = ground.map().width();
            patchOf = new int[ground.map().cells().length];
            Arrays.fill(patchOf, -1);
            var queue = new int[side * side];
            for (int cell : ground.cells()) {
                if (patchOf[cell] < 0) {
                    if (count == places.length) {
                        grow();
                    }
                    int size = fill(ground, cell, side, width, queue);
                    describe(ground, queue, size, width);
                    count++;
                }
            }
        }

        private void grow() {
            places = Arrays.copyOf(places, 2 * count);
            weights = Arrays.copyOf(weights, 2 * count);
            x = Arrays.copyOf(x, 2 * count);
            y = Arrays.copyOf(y, 2 * count);
        }

        private int fill(ReachableSpace ground, int start, int side, int width, int[] queue) {
            int left = start % width / side * side;
            int bottom = start / width / side * side;
            int end = 0;
            patchOf[start] = count;
            queue[end++] = start;
            for (int next = 0; next < end; next++) {
                int column = queue[next] % width;
                int row = queue[next] / width;
                for (int distance = 0; distance < 4; distance++) {
                    int toColumn = column + (distance == 0 ? 1 : distance == 1 ? -1 : 0);
                    int toRow = row + (distance == 2 ? 1 : distance == 3 ? -1 : 0);
                    int to = toRow * width + toColumn;
                    boolean within =
                            toColumn >= left && toColumn < left + side && toRow >= bottom && toRow < bottom + side;
                    if (within && ground.isIn(to) && patchOf[to] < 0) {
                        patchOf[to] = count;
                        queue[end++] = to;
                    }
                }
            }
            return end;
        }

        /// Where its middle is, and its cell next to that, a roomy one if it has any.
        private void describe(ReachableSpace ground, int[] cells, int size, int width) {
            double sumX = 0;
            double sumY = 0;
            for (int i = 0; i < size; i++) {
                int row = cells[i] / width;
                sumX += cells[i] % width;
                sumY += row;
            }
            x[count] = sumX / size;
            y[count] = sumY / size;
            double least = Double.POSITIVE_INFINITY;
            boolean roomy = false;
            for (int i = 0; i < size; i++) {
                boolean better = ground.isRoomy(cells[i]);
                if (roomy && !better) {
                    continue;
                }
                int row = cells[i] / width;
                double dx = cells[i] % width - x[count];
                double dy = row - y[count];
                if (better != roomy || dx * dx + dy * dy < least) {
                    roomy = better;
                    least = dx * dx + dy * dy;
                    places[count] = cells[i];
                }
            }
            weights[count] = size;
        }
    }

    /// Neighbors, each pair both ways, sorted: from whom in the upper half, to whom in the lower.
    private long[] pairs(ReachableSpace ground, int side, int width) {
        var pairs = new long[16 * count];
        int number = 0;
        for (int cell : ground.cells()) {
            boolean endOfRow = (cell % width + 1) % side == 0;
            boolean startOfRow = cell % width % side == 0;
            boolean top = (cell / width + 1) % side == 0;
            if (!top && !endOfRow) {
                continue;
            }
            if (number + 8 > pairs.length) {
                pairs = Arrays.copyOf(pairs, 2 * pairs.length);
            }
            boolean right = ground.isIn(cell + 1);
            boolean up = ground.isIn(cell + width);
            if (endOfRow && right) {
                number = both(pairs, number, patchOf[cell], patchOf[cell + 1]);
            }
            if (top && up) {
                number = both(pairs, number, patchOf[cell], patchOf[cell + width]);
            }
            if (top && endOfRow && up && right && ground.isIn(cell + width + 1)) {
                number = both(pairs, number, patchOf[cell], patchOf[cell + width + 1]);
            }
            if (top && startOfRow && up && ground.isIn(cell - 1) && ground.isIn(cell + width - 1)) {
                number = both(pairs, number, patchOf[cell], patchOf[cell + width - 1]);
            }
        }
        Arrays.sort(pairs, 0, number);
        int different = 0;
        for (int i = 0; i < number; i++) {
            if (i == 0 || pairs[i] != pairs[i - 1]) {
                pairs[different++] = pairs[i];
            }
        }
        return Arrays.copyOf(pairs, different);
    }

    private static int both(long[] pairs, int number, int one, int other) {
        pairs[number] = (long) one << 32 | other;
        pairs[number + 1] = (long) other << 32 | one;
        return number + 2;
    }

    /// Of a block, in cells.
    int side() {
        return side;
    }

    /// How many there are.
    int count() {
        return count;
    }

    /// The patch that a cell of the ground is in.
    int of(int cell) {
        return patchOf[cell];
    }

    /// Which patches are wide enough for two robots at their place. Not to be written to.
    boolean[] roomy() {
        return roomy;
    }

    /// A patch's cell next to its middle, of the roomy ones if it has any.
    int place(int patch) {
        return places[patch];
    }

    /// How many cells a patch has.
    int weight(int patch) {
        return weights[patch];
    }

    /// Number of a patch's first neighbor; its last is the one before the next patch's first.
    int first(int patch) {
        return first[patch];
    }

    int neighbor(int number) {
        return neighbors[number];
    }

    /// How far the neighbor of that number is.
    int length(int number) {
        return lengths[number];
    }

    /// How far neighbors are apart at most.
    int longest() {
        return longest;
    }
}
