package rsal.navigation.passage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;

/// Finds places at which corridors meet. About such a place runs a circle, a little larger than the free one, that
/// walls
/// divide into arcs; each arc from which a robot gets farther away is a corridor. With three or more, the place is a
/// branching point of the medial axis (Thrun 1998), found without the axis itself, whose small branches furniture
/// makes.
final class JunctionSearch {
    private static final int LEAST_ARMS = 3;
    private static final double BEYOND = 0.45; // m by which the circle is larger than the free one
    private static final double WIDEST = 2.4; // m of clearance; where there is more, robots drive around each other
    private static final double REACH = 2.0; // m that a corridor leads on at least, outside of the circle
    private static final double STOP = 0.1; // m between the free circle and who waits
    private static final double SLACK = 0.15; // m by which an arm may be narrower than two robots need

    private final CostMap open;
    private final DistanceField toNotFree;
    private final OccupancyGrid grid;
    private final int[] passages; // by cell; -1 outside of any
    private final double body;
    private final int[] seen;
    private int floods;

    private record Candidate(int cell, int arms, double clearance) {}

    /// @param passages by cell; -1 outside of any
    /// @param body radius of the circle that a robot turns in [m]
    JunctionSearch(CostMap open, DistanceField toNotFree, int[] passages, double body) {
        this.open = open;
        this.toNotFree = toNotFree;
        this.grid = open.grid();
        this.passages = passages;
        this.body = body;
        this.seen = new int[passages.length];
    }

    List<Junction> find() {
        var candidates = new ArrayList<Candidate>();
        double least = Passages.halfWidth(body);
        for (int cell = 0; cell < passages.length; cell++) {
            double clearance = toNotFree.at(cell);
            if (open.isOpen(cell) && passages[cell] < 0 && clearance >= least && clearance <= WIDEST) {
                int arms = arms(cell, clearance);
                if (arms >= LEAST_ARMS) {
                    candidates.add(new Candidate(cell, arms, clearance));
                }
            }
        }
        candidates.sort(Comparator.comparingInt(Candidate::arms)
                .thenComparingDouble(Candidate::clearance)
                .reversed()
                .thenComparingInt(Candidate::cell));
        var found = new ArrayList<Junction>();
        for (Candidate candidate : candidates) {
            Point2d center = grid.middle(candidate.cell());
            if (found.stream().noneMatch(other -> other.contains(center))) {
                found.add(new Junction(center, candidate.clearance() + STOP));
            }
        }
        return found;
    }

    /// How many corridors lead away from a place.
    private int arms(int cell, double clearance) {
        double radius = clearance + BEYOND;
        Point2d center = grid.middle(cell);
        int samples = (int) Math.ceil(2 * Math.PI * radius / grid.resolution());
        var ring = new int[samples];
        int blocked = -1;
        for (int i = 0; i < samples; i++) {
            double angle = 2 * Math.PI * i / samples;
            ring[i] = standing(center.x() + radius * Math.cos(angle), center.y() + radius * Math.sin(angle));
            if (ring[i] < 0) {
                blocked = i;
            }
        }
        if (blocked < 0) {
            return 0;
        }
        int[][] arcs =
                arcs(ring, blocked, (int) ((2 * Passages.halfWidth(body) - SLACK - 2 * body) / grid.resolution()));
        if (arcs.length < LEAST_ARMS) {
            return 0;
        }
        return (int)
                Arrays.stream(arcs).filter(arc -> leadsOn(arc, center, radius)).count();
    }

    /// The cell at a place, if a robot can turn there and it is in no passage; else -1.
    private int standing(double x, double y) {
        int column = grid.column(x);
        int row = grid.row(y);
        if (!grid.contains(column, row)) {
            return -1;
        }
        int cell = row * grid.width() + column;
        return open.isOpen(cell) && toNotFree.at(cell) >= body && passages[cell] < 0 ? cell : -1;
    }

    private static int[][] arcs(int[] ring, int blocked, int least) {
        var arcs = new ArrayList<int[]>();
        int length = 0;
        for (int i = 1; i <= ring.length; i++) {
            if (ring[(blocked + i) % ring.length] >= 0) {
                length++;
            } else {
                if (length >= least) {
                    var arc = new int[length];
                    for (int k = 0; k < length; k++) {
                        arc[k] = ring[(blocked + i - length + k) % ring.length];
                    }
                    arcs.add(arc);
                }
                length = 0;
            }
        }
        return arcs.toArray(int[][]::new);
    }

    private boolean leadsOn(int[] arc, Point2d center, double radius) {
        floods++;
        var cells = new IntList();
        for (int cell : arc) {
            if (seen[cell] != floods) {
                seen[cell] = floods;
                cells.add(cell);
            }
        }
        for (int i = 0; i < cells.size(); i++) {
            int cell = cells.get(i);
            for (int next : new int[] {cell - 1, cell + 1, cell - grid.width(), cell + grid.width()}) {
                if (seen[next] != floods && open.isOpen(next) && toNotFree.at(next) >= body) {
                    double distance = grid.middle(next).distanceTo(center);
                    if (distance >= radius + REACH) {
                        return true;
                    }
                    if (distance >= radius) {
                        seen[next] = floods;
                        cells.add(next);
                    }
                }
            }
        }
        return false;
    }
}
