package rsal.navigation.passage;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;

/// Finds places at which corridors meet. Walls divide a circle around such a place, a little larger than the free one,
/// into arcs. Each arc from which a robot gets farther away is a corridor. With three or more, the place is a branching
/// point of the medial axis (S. Thrun, "Learning metric-topological maps for indoor mobile robot navigation", 1998).
/// The
/// axis itself is not computed, since furniture adds small branches to it. Of one thread.
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
    private final int leastArc; // cells; narrower arcs are no corridors
    private final int[] seen; // by cell, the number of the flood that has reached it
    private final int[] waiting; // cells of the flood whose neighbors were not looked at
    private final int[] sides; // of a cell, as differences of indices
    private final Map<Double, Ring> rings = new HashMap<>(); // by clearance
    private final List<Arc> arcs = new ArrayList<>();
    private int[] around = {}; // cells of the ring around a place; -1 where no robot can stand
    private int floods;

    private record Candidate(int cell, int arms, double clearance) {}

    /// Neighboring places of the ring at which a robot can stand.
    private record Arc(int first, int length) {}

    /// A circle around the middle of a cell, as differences of columns and rows, counter-clockwise.
    private record Ring(int[] columns, int[] rows) {
        int size() {
            return columns.length;
        }
    }

    /// @param passages by cell; -1 outside of any
    /// @param body radius of the circle that a robot turns in [m]
    JunctionSearch(CostMap open, DistanceField toNotFree, int[] passages, double body) {
        this.open = open;
        this.toNotFree = toNotFree;
        this.grid = open.grid();
        this.passages = passages;
        this.body = body;
        this.leastArc = (int) ((2 * Passages.halfWidth(body) - SLACK - 2 * body) / grid.resolution());
        this.seen = new int[passages.length];
        this.waiting = new int[passages.length];
        this.sides = new int[] {-1, 1, -grid.width(), grid.width()};
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
        Ring ring = rings.computeIfAbsent(clearance, this::ring);
        int column = cell % grid.width();
        int row = cell / grid.width();
        int blocked = -1;
        for (int i = 0; i < ring.size(); i++) {
            around[i] = standing(column + ring.columns()[i], row + ring.rows()[i]);
            if (around[i] < 0) {
                blocked = i;
            }
        }
        return blocked < 0 ? 0 : arms(cell, clearance + BEYOND, ring.size(), blocked);
    }

    private Ring ring(double clearance) {
        double cells = (clearance + BEYOND) / grid.resolution();
        int size = (int) Math.ceil(2 * Math.PI * cells);
        var columns = new int[size];
        var rows = new int[size];
        for (int i = 0; i < size; i++) {
            double angle = 2 * Math.PI * i / size;
            columns[i] = (int) Math.floor(0.5 + cells * Math.cos(angle));
            rows[i] = (int) Math.floor(0.5 + cells * Math.sin(angle));
        }
        around = size > around.length ? new int[size] : around;
        return new Ring(columns, rows);
    }

    /// The cell at a place, if a robot can turn there and it is in no passage; else -1.
    private int standing(int column, int row) {
        if (!grid.contains(column, row)) {
            return -1;
        }
        int cell = row * grid.width() + column;
        return open.isOpen(cell) && toNotFree.at(cell) >= body && passages[cell] < 0 ? cell : -1;
    }

    /// @param size of the ring around the place
    /// @param blocked index in the ring at which no robot can stand
    private int arms(int cell, double radius, int size, int blocked) {
        arcs.clear();
        int length = 0;
        for (int i = 1; i <= size; i++) {
            if (around[(blocked + i) % size] >= 0) {
                length++;
                continue;
            }
            if (length >= leastArc) {
                arcs.add(new Arc((blocked + i - length) % size, length));
            }
            length = 0;
        }
        if (arcs.size() < LEAST_ARMS) {
            return 0;
        }
        return (int)
                arcs.stream().filter(arc -> leadsOn(arc, size, cell, radius)).count();
    }

    /// Whether a robot gets away from a place, beginning at an arc of the ring around it.
    private boolean leadsOn(Arc arc, int size, int center, double radius) {
        floods++;
        int last = 0;
        for (int i = 0; i < arc.length(); i++) {
            last = flood(around[(arc.first() + i) % size], last);
        }
        double near = square(radius / grid.resolution());
        double far = square((radius + REACH) / grid.resolution());
        int width = grid.width();
        int centerColumn = center % width;
        int centerRow = center / width;
        while (last > 0) { // the newest first, as that gets away soonest
            last--;
            int cell = waiting[last];
            for (int side : sides) {
                int next = cell + side;
                if (seen[next] != floods && open.isOpen(next) && toNotFree.at(next) >= body) {
                    double squared = square(next % width - centerColumn) + square(next / width - centerRow);
                    if (squared >= far) {
                        return true;
                    }
                    if (squared >= near) {
                        last = flood(next, last);
                    }
                }
            }
        }
        return false;
    }

    private int flood(int cell, int last) {
        if (seen[cell] == floods) {
            return last;
        }
        seen[cell] = floods;
        waiting[last] = cell;
        return last + 1;
    }

    private static double square(double value) {
        return value * value;
    }
}
