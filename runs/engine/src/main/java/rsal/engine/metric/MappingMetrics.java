package rsal.engine.metric;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Stamped;

/// How much of a floor robots can get to, and how much of that is on maps.
final class MappingMetrics {
    private static final double SLACK = 0.5; // m; from where a robot is to where its middle may be

    private final OccupancyGrid floor;
    private final double radius;
    private @Nullable BitSet passable;
    private final BitSet reachable = new BitSet();
    private List<Instant> judged = List.of(); // when the maps were drawn
    private double share = Double.NaN;

    /// @param floor as it is
    /// @param radius of robots: their middles keep as far from walls [m]
    MappingMetrics(OccupancyGrid floor, double radius) {
        this.floor = floor;
        this.radius = radius;
    }

    /// A robot can get to where others that started here can.
    void starts(Point2d at) {
        if (passable == null) {
            passable = passable();
        }
        BitSet open = passable;
        near(at, open).ifPresent(cell -> flood(cell, open));
        judged = List.of();
    }

    /// The share of the places that robots can get to which is free on one of the maps; NaN when there is no map or
    /// no place.
    double share(Collection<Stamped<OccupancyGrid>> maps) {
        List<Instant> times = maps.stream().map(Stamped::time).toList();
        if (!times.equals(judged)) {
            judged = times;
            share = judge(maps.stream().map(Stamped::value).distinct().toList());
        }
        return share;
    }

    private double judge(List<OccupancyGrid> maps) {
        if (maps.isEmpty() || reachable.isEmpty()) {
            return Double.NaN;
        }
        int free = 0;
        for (int cell = reachable.nextSetBit(0); cell >= 0; cell = reachable.nextSetBit(cell + 1)) {
            Point2d place = floor.middle(cell);
            free += maps.stream().anyMatch(map -> map.isFree(place.x(), place.y())) ? 1 : 0;
        }
        return (double) free / reachable.cardinality();
    }

    /// Free cells that are far enough from those that are not, and from the edge.
    private BitSet passable() {
        int width = floor.width();
        int height = floor.height();
        int reach = (int) Math.ceil(radius / floor.resolution());
        var open = new BitSet(width * height);
        for (int cell = 0; cell < width * height; cell++) {
            open.set(cell, floor.cells()[cell] == OccupancyGrid.FREE);
        }
        var clear = (BitSet) open.clone();
        for (int cell = open.nextClearBit(0); cell < width * height; cell = open.nextClearBit(cell + 1)) {
            int column = cell % width;
            int row = cell / width;
            boolean inside = isSolid(open, column - 1, row)
                    && isSolid(open, column + 1, row)
                    && isSolid(open, column, row - 1)
                    && isSolid(open, column, row + 1);
            for (int down = -reach; !inside && down <= reach; down++) {
                int at = row + down;
                int wide = (int) Math.sqrt((double) reach * reach - (double) down * down);
                if (at >= 0 && at < height) {
                    clear.clear(
                            at * width + Math.max(0, column - wide), at * width + Math.min(width, column + wide + 1));
                }
            }
        }
        for (int row = 0; row < height; row++) {
            boolean edge = row < reach || row >= height - reach;
            clear.clear(row * width, row * width + (edge ? width : Math.min(reach, width)));
            clear.clear(row * width + Math.max(0, width - reach), (row + 1) * width);
        }
        return clear;
    }

    private boolean isSolid(BitSet open, int column, int row) {
        return column < 0
                || row < 0
                || column >= floor.width()
                || row >= floor.height()
                || !open.get(row * floor.width() + column);
    }

    private Optional<Integer> near(Point2d at, BitSet open) {
        int cells = (int) Math.ceil(SLACK / floor.resolution());
        int column = floor.column(at.x());
        int row = floor.row(at.y());
        Integer nearest = null;
        double distance = SLACK;
        for (int r = Math.max(0, row - cells); r <= Math.min(floor.height() - 1, row + cells); r++) {
            for (int c = Math.max(0, column - cells); c <= Math.min(floor.width() - 1, column + cells); c++) {
                int cell = r * floor.width() + c;
                double away = floor.middle(cell).distanceTo(at);
                if (open.get(cell) && away <= distance) {
                    nearest = cell;
                    distance = away;
                }
            }
        }
        return Optional.ofNullable(nearest);
    }

    private void flood(int from, BitSet open) {
        if (reachable.get(from)) {
            return;
        }
        int width = floor.width();
        var next = new ArrayDeque<Integer>();
        reachable.set(from);
        next.add(from);
        while (!next.isEmpty()) {
            int cell = next.remove();
            for (int other : new int[] {cell - 1, cell + 1, cell - width, cell + width}) { // none is at the edge
                if (other >= 0 && open.get(other) && !reachable.get(other)) {
                    reachable.set(other);
                    next.add(other);
                }
            }
        }
    }
}
