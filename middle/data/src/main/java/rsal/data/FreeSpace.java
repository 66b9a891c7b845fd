package rsal.data;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;

/// The largest connected part of a map in which a robot can be with some distance to all that is not free: places
/// to start from, from each of which all others can be reached.
public final class FreeSpace {
    /// Of robots that are put somewhere at random, from all that is not free and from other robots [m].
    public static final double START_CLEARANCE = 0.4;

    private static final int TRIES = 1000;

    private final OccupancyGrid map;
    private final int[] cells; // of the largest part

    /// @param clearance half the side of a square around a cell's middle that must be free [m]
    public FreeSpace(OccupancyGrid map, double clearance) {
        this(map, clearance, clearance);
    }

    /// Places with room around them, rooms with narrow doors included.
    ///
    /// @param clearance half the side of a square around a cell's middle that must be free [m]
    /// @param passage the same for what connects them, at most the clearance [m]
    public FreeSpace(OccupancyGrid map, double clearance, double passage) {
        this.map = map;
        boolean[] open = open(map, reach(map, passage));
        int[] found = new int[open.length]; // one part after the other
        int from = 0;
        int largestFrom = 0;
        int largestTo = 0;
        for (int cell = 0; cell < open.length; cell++) {
            if (open[cell]) {
                int to = collectPart(map, cell, open, found, from);
                if (to - from > largestTo - largestFrom) {
                    largestFrom = from;
                    largestTo = to;
                }
                from = to;
            }
        }
        if (reach(map, clearance) == reach(map, passage)) { // as mostly, and then all of them have room
            cells = Arrays.copyOfRange(found, largestFrom, largestTo);
        } else {
            boolean[] roomy = open(map, reach(map, clearance));
            cells = Arrays.stream(found, largestFrom, largestTo)
                    .filter(cell -> roomy[cell])
                    .toArray();
        }
    }

    /// How many cells around a cell must be free; free spaces of equal reach are equal.
    ///
    /// @param clearance as for a free space [m]
    public static int reach(OccupancyGrid map, double clearance) {
        return (int) Math.ceil(clearance / map.resolution() - 0.5);
    }

    /// Free cells that are connected with some by their sides, whatever room there is.
    ///
    /// @param starts cells; those that are not free lead nowhere
    public static BitSet connected(OccupancyGrid map, Collection<Integer> starts) {
        boolean[] open = open(map, 0);
        int[] found = new int[open.length];
        int end = 0;
        for (int start : starts) {
            if (open[start]) {
                end = collectPart(map, start, open, found, end);
            }
        }
        var connected = new BitSet(open.length);
        Arrays.stream(found, 0, end).forEach(connected::set);
        return connected;
    }

    /// Cells with none but free ones `reach` cells around, by a summed-area table of the others.
    private static boolean[] open(OccupancyGrid map, int reach) {
        int width = map.width();
        int height = map.height();
        int[] sums = new int[(width + 1) * (height + 1)];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int blocked = map.cells()[row * width + column] == OccupancyGrid.FREE ? 0 : 1;
                int at = (row + 1) * (width + 1) + column + 1;
                sums[at] = blocked + sums[at - 1] + sums[at - width - 1] - sums[at - width - 2];
            }
        }
        boolean[] open = new boolean[width * height];
        for (int row = reach; row < height - reach; row++) {
            for (int column = reach; column < width - reach; column++) {
                int below = (row - reach) * (width + 1) + column;
                int above = (row + reach + 1) * (width + 1) + column;
                int blocked =
                        sums[above + reach + 1] - sums[above - reach] - sums[below + reach + 1] + sums[below - reach];
                open[row * width + column] = blocked == 0;
            }
        }
        return open;
    }

    /// Moves all cells that are connected with one from `open` to the end of `found`.
    ///
    /// @return the new end
    private static int collectPart(OccupancyGrid map, int first, boolean[] open, int[] found, int from) {
        int width = map.width();
        int last = open.length - width;
        int end = from;
        open[first] = false;
        found[end++] = first;
        for (int next = from; next < end; next++) {
            int cell = found[next];
            int column = cell % width;
            if (column + 1 < width && open[cell + 1]) {
                open[cell + 1] = false;
                found[end++] = cell + 1;
            }
            if (column > 0 && open[cell - 1]) {
                open[cell - 1] = false;
                found[end++] = cell - 1;
            }
            if (cell < last && open[cell + width]) {
                open[cell + width] = false;
                found[end++] = cell + width;
            }
            if (cell >= width && open[cell - width]) {
                open[cell - width] = false;
                found[end++] = cell - width;
            }
        }
        return end;
    }

    /// How many cells it has.
    int area() {
        return cells.length;
    }

    /// The place nearest to another that suits, with the other's heading; empty when none of the thousand nearest
    /// does.
    public Optional<Pose2d> nearest(Pose2d other, Predicate<Pose2d> suits) {
        return Arrays.stream(cells)
                .mapToObj(cell -> new Pose2d(x(cell), y(cell), other.theta()))
                .sorted(Comparator.comparingDouble(other::distanceTo))
                .limit(TRIES)
                .filter(suits)
                .findFirst();
    }

    /// A place that suits, looking anywhere; empty when none of a thousand did.
    public Optional<Pose2d> choose(RandomGenerator random, Predicate<Pose2d> suits) {
        for (int i = 0; i < TRIES && cells.length > 0; i++) {
            int cell = cells[random.nextInt(cells.length)];
            var pose = new Pose2d(x(cell), y(cell), random.nextDouble(-Math.PI, Math.PI));
            if (suits.test(pose)) {
                return Optional.of(pose);
            }
        }
        return Optional.empty();
    }

    private double x(int cell) {
        return map.x(cell % map.width());
    }

    private double y(int cell) {
        return map.y(cell / map.width());
    }
}
