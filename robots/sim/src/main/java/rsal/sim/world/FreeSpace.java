package rsal.sim.world;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;

/// The largest connected part of a map in which a robot can be with some distance to all that is not free: places
/// to start from, from each of which all others can be reached.
public final class FreeSpace {
    private static final int TRIES = 1000;

    private final OccupancyGrid map;
    private final int[] cells; // of the largest part

    /// @param clearance from the middle of a cell to the nearest one that is not free [m], along the worse axis
    public FreeSpace(OccupancyGrid map, double clearance) {
        this.map = map;
        boolean[] open = open(clearance);
        int[] found = new int[open.length]; // one part after the other
        int from = 0;
        int largestFrom = 0;
        int largestTo = 0;
        for (int cell = 0; cell < open.length; cell++) {
            if (open[cell]) {
                int to = collectPart(cell, open, found, from);
                if (to - from > largestTo - largestFrom) {
                    largestFrom = from;
                    largestTo = to;
                }
                from = to;
            }
        }
        cells = Arrays.copyOfRange(found, largestFrom, largestTo);
    }

    private boolean[] open(double clearance) {
        byte[] known = map.cells().clone();
        for (int i = 0; i < known.length; i++) {
            known[i] = known[i] == OccupancyGrid.FREE ? OccupancyGrid.FREE : OccupancyGrid.OCCUPIED;
        }
        var walls = new Walls(
                new OccupancyGrid(map.width(), map.height(), map.resolution(), map.originX(), map.originY(), known));
        boolean[] open = new boolean[known.length];
        for (int i = 0; i < open.length; i++) {
            double empty = walls.emptyAround(x(i), y(i));
            open[i] = empty >= 0 && empty + map.resolution() / 2 >= clearance;
        }
        return open;
    }

    /// Moves all cells that are connected with one from `open` to the end of `found`.
    ///
    /// @return the new end
    private int collectPart(int first, boolean[] open, int[] found, int from) {
        int end = from;
        open[first] = false;
        found[end++] = first;
        for (int next = from; next < end; next++) {
            int cell = found[next];
            int column = cell % map.width();
            int row = cell / map.width();
            for (int side = 0; side < 4; side++) {
                int toColumn = column + (side == 0 ? 1 : side == 1 ? -1 : 0);
                int toRow = row + (side == 2 ? 1 : side == 3 ? -1 : 0);
                int neighbor = toRow * map.width() + toColumn;
                if (map.contains(toColumn, toRow) && open[neighbor]) {
                    open[neighbor] = false;
                    found[end++] = neighbor;
                }
            }
        }
        return end;
    }

    /// Area [m²].
    public double area() {
        return cells.length * map.resolution() * map.resolution();
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
