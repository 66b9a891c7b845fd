package rsal.navigation.rooms;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// What stands free on a floor and is no wall. Whatever is occupied or unknown and connected, across corners
/// too, is compact when it is thick and fills a rectangle of its second moments (M.-K. Hu, Visual pattern
/// recognition by moment invariants, IRE Transactions on Information Theory 8, 1962). It is small when it is
/// short: a leg, a chair, a pillar, a compact table. A longer compact one is large furniture if it divides
/// nothing: no gate ends at it, or only wide ones that together are longer than it is. A piece of a wall
/// between two doors is thin, or bent, or longer than the doors are wide.
final class LooseFurniture {
    private static final double SMALL = 0.8; // m, long
    private static final double COMPACT = 1.6; // m, long, and thick: tables
    private static final double THICK = 0.4; // m; walls are thinner, and long
    private static final double FULL = 0.5; // share of its rectangle; bent walls fill less
    private static final double WIDE = 1.4; // m; gates that are no doors
    private static final int BESIDE = 3; // cells, from the end of a gate to what it ends at

    private final OccupancyGrid map;
    private final double longest;
    private final List<Island> small = new ArrayList<>();
    private final List<Island> large = new ArrayList<>();

    /// @param cells not to be written to
    /// @param length of the rectangle with its moments [m]
    private record Island(int[] cells, double length) {}

    private LooseFurniture(OccupancyGrid map, double longest) {
        this.map = map;
        this.longest = longest;
        byte[] cells = map.cells();
        var seen = new boolean[cells.length];
        var queue = new int[cells.length];
        for (int cell = 0; cell < cells.length; cell++) {
            if (cells[cell] != OccupancyGrid.FREE && !seen[cell]) {
                sort(queue, component(cell, seen, queue));
            }
        }
    }

    /// @param longest length of furniture [m]; 0: there is none
    static LooseFurniture of(OccupancyGrid map, double longest) {
        return new LooseFurniture(map, longest);
    }

    /// Lists all that is connected with a cell and not free.
    private int component(int first, boolean[] seen, int[] queue) {
        int width = map.width();
        int end = 0;
        queue[end++] = first;
        seen[first] = true;
        for (int next = 0; next < end; next++) {
            int column = queue[next] % width;
            int row = queue[next] / width;
            for (int r = Math.max(0, row - 1); r <= Math.min(map.height() - 1, row + 1); r++) {
                for (int c = Math.max(0, column - 1); c <= Math.min(width - 1, column + 1); c++) {
                    int cell = r * width + c;
                    if (!seen[cell] && map.cells()[cell] != OccupancyGrid.FREE) {
                        seen[cell] = true;
                        queue[end++] = cell;
                    }
                }
            }
        }
        return end;
    }

    private void sort(int[] cells, int size) {
        double most = longest / map.resolution();
        if (size > most * most) {
            return;
        }
        double sumX = 0;
        double sumY = 0;
        for (int i = 0; i < size; i++) {
            int column = cells[i] % map.width();
            int row = cells[i] / map.width();
            if (column == 0 || row == 0 || column == map.width() - 1 || row == map.height() - 1) {
                return; // it may go on beyond the map
            }
            sumX += column;
            sumY += row;
        }
        double xx = 1.0 / 12; // of a cell itself
        double yy = 1.0 / 12;
        double xy = 0;
        for (int i = 0; i < size; i++) {
            int row = cells[i] / map.width();
            double dx = cells[i] % map.width() - sumX / size;
            double dy = row - sumY / size;
            xx += dx * dx / size;
            yy += dy * dy / size;
            xy += dx * dy / size;
        }
        double mean = (xx + yy) / 2;
        double apart = Math.hypot((xx - yy) / 2, xy);
        double length = Math.sqrt(12 * (mean + apart)) * map.resolution(); // of a full rectangle with these moments
        double width = Math.sqrt(12 * Math.max(0, mean - apart)) * map.resolution();
        double area = size * map.resolution() * map.resolution();
        boolean isCompact = width >= THICK && area >= FULL * length * width;
        if (length <= Math.min(isCompact ? COMPACT : SMALL, longest)) {
            small.add(new Island(Arrays.copyOf(cells, size), length));
        } else if (isCompact && length <= longest) {
            large.add(new Island(Arrays.copyOf(cells, size), length));
        }
    }

    /// The map, free where small furniture was.
    OccupancyGrid withoutSmall() {
        return cleared(map, small);
    }

    /// A map, free where large furniture was that divides nothing; the same map when there is none.
    ///
    /// @param gates of the map without small furniture
    OccupancyGrid without(OccupancyGrid bare, List<RoomGate> gates) {
        var islandOf = new int[map.cells().length]; // number and 1; 0: none
        for (int number = 0; number < large.size(); number++) {
            for (int cell : large.get(number).cells) {
                islandOf[cell] = number + 1;
            }
        }
        var open = new double[large.size() + 1]; // m
        var isWall = new boolean[large.size() + 1];
        for (RoomGate gate : gates) {
            var touched = new TreeSet<Integer>();
            around(gate.from(), islandOf, touched);
            around(gate.to(), islandOf, touched);
            for (int island : touched) {
                open[island] += gate.width();
                isWall[island] |= gate.width() < WIDE;
            }
        }
        var divideNothing = new ArrayList<Island>();
        for (int number = 0; number < large.size(); number++) {
            Island island = large.get(number);
            boolean isBeside = open[number + 1] > 0;
            if (!isBeside || (!isWall[number + 1] && open[number + 1] >= island.length)) {
                divideNothing.add(island);
            }
        }
        return divideNothing.isEmpty() ? bare : cleared(bare, divideNothing);
    }

    private void around(Point2d place, int[] islandOf, Set<Integer> touched) {
        int column = map.column(place.x());
        int row = map.row(place.y());
        for (int r = row - BESIDE; r <= row + BESIDE; r++) {
            for (int c = column - BESIDE; c <= column + BESIDE; c++) {
                if (map.contains(c, r) && islandOf[r * map.width() + c] > 0) {
                    touched.add(islandOf[r * map.width() + c]);
                }
            }
        }
    }

    private static OccupancyGrid cleared(OccupancyGrid map, List<Island> islands) {
        byte[] cells = map.cells().clone();
        for (Island island : islands) {
            for (int cell : island.cells) {
                cells[cell] = OccupancyGrid.FREE;
            }
        }
        return new OccupancyGrid(map.width(), map.height(), map.resolution(), map.originX(), map.originY(), cells);
    }
}
