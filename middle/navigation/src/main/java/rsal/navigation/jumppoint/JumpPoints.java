package rsal.navigation.jumppoint;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.Ends;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.navigation.wavefront.OpenParts;
import rsal.navigation.wavefront.Plan;

/// Finds shortest ways for single questions, without a wave over the whole map: jump point search (D. Harabor,
/// A. Grastien, Online Graph Pruning for Pathfinding on Grid Maps, AAAI 2011, definitions 1 and 2, algorithms 1 and 2),
/// which of all equally long ways over the eight neighbors follows one, and looks at cells only where it can turn.
///
/// Differs from the paper in these points:
/// * Ways do not cut corners: a step across one needs both cells beside it. So neighbors are forced one cell later.
/// * Many cells are scanned at once ([OpenCells]).
/// * Costs are whole numbers, 10 and 14, so that ways which are as long compare as such.
/// * A cell that is reached again by a way as long goes on in those directions only that are new.
/// * The way is pulled straight in the end wherever a robot can go straight, so it may have any angle.
///
/// Knows where a robot can be but not how dear it is to be there: ways go by as near to obstacles as is allowed.
/// [rsal.navigation.wavefront.Wavefront] plans ways that keep off.
///
/// May be asked on any thread; one search at a time. What it finds does not depend on what it found before.
public final class JumpPoints implements GlobalPlanner {
    private static final int SIDE = 10;
    private static final int DIAGONAL = 14;
    private static final int UNREACHED = Integer.MAX_VALUE;
    private static final int[] DX = {1, 1, 0, -1, -1, -1, 0, 1}; // counterclockwise from +x
    private static final int[] DY = {0, 1, 1, 1, 0, -1, -1, -1};
    private static final int ALL = 0xff;

    private final CostMap map;
    private final BitSet blocked;
    private final OccupancyGrid grid;
    private final OpenCells cells;
    private final int[] reached;
    private final int[] from;
    private final byte[] taken; // directions in which ways went on, as bits
    private final List<Integer> touched = new ArrayList<>();
    private @Nullable OpenParts parts; // found when somebody first asks for a place that no way leads to
    private int goalColumn;
    private int goalRow;

    /// @param estimate least that a way through it costs
    /// @param directions in which it goes on, as bits
    private record Open(int estimate, int reached, int cell, int directions) implements Comparable<Open> {
        @Override
        public int compareTo(Open other) {
            int order = Integer.compare(estimate, other.estimate);
            return order != 0 ? order : Integer.compare(cell, other.cell);
        }
    }

    public JumpPoints(CostMap map) {
        this(map, new BitSet());
    }

    /// @param blocked cells where the robot can't be besides those of the map
    private JumpPoints(CostMap map, BitSet blocked) {
        this.map = map;
        this.blocked = blocked;
        this.grid = map.grid();
        this.cells = new OpenCells(grid.width(), grid.height(), this::isOpen);
        this.reached = new int[grid.width() * grid.height()];
        this.from = new int[reached.length];
        this.taken = new byte[reached.length];
        Arrays.fill(reached, UNREACHED);
    }

    private boolean isOpen(int cell) {
        return map.isOpen(cell) && !blocked.get(cell);
    }

    @Override
    public CostMap map() {
        return map;
    }

    @Override
    public Plan plan(Point2d start, Point2d goal, double slack, List<Point2d> obstacles) {
        if (obstacles.isEmpty()) {
            return plan(start, goal, slack);
        }
        var around = new BitSet();
        obstacles.forEach(obstacle -> map.around(obstacle, around::set));
        return new JumpPoints(map, around).plan(start, goal, slack);
    }

    /// Plans a shortest way. A start too near to obstacles is left for the nearest place where the robot can be. A
    /// goal where it can't get is replaced by the nearest place where it can, when that is no farther away than
    /// `slack` [m].
    public synchronized Plan plan(Point2d start, Point2d goal, double slack) {
        var ends = Ends.of(map, start, goal, slack, this::isOpen);
        if (ends instanceof Ends.None(var why)) {
            return why;
        }
        var cells = (Ends.Cells) ends;
        int end = cells.goal();
        if (parts != null || search(cells.start(), end) < 0) {
            OpenParts known = parts();
            int own = known.of(cells.start());
            if (known.of(end) != own) {
                end = Ends.nearest(grid, goal, slack, cell -> known.of(cell) == own);
            }
            if (end < 0) {
                return Ends.apart(goal);
            }
            search(cells.start(), end);
        }
        Path2d path = straight(points(cells.start(), end), start, goal);
        return new Plan.Found(path, path.length(), path.points().getLast().distanceTo(goal));
    }

    /// @return length of the shortest way over the eight neighbors, where a side counts [#SIDE]; −1 when there is none
    int search(int startCell, int goalCell) {
        touched.forEach(cell -> reached[cell] = UNREACHED);
        touched.clear();
        goalColumn = goalCell % cells.width;
        goalRow = goalCell / cells.width;
        var open = new PriorityQueue<Open>();
        arrive(startCell, 0, ALL, startCell, open);
        while (!open.isEmpty()) {
            Open next = open.poll();
            if (next.reached > reached[next.cell]) {
                continue; // was reached by a shorter way since
            }
            if (next.cell == goalCell) {
                return next.reached;
            }
            for (int direction = 0; direction < 8; direction++) {
                if ((next.directions & (1 << direction)) != 0) {
                    jump(next, direction, open);
                }
            }
        }
        return -1;
    }

    private OpenParts parts() {
        OpenParts known = parts;
        if (known == null) {
            known = new OpenParts(map, this::isOpen);
            parts = known;
        }
        return known;
    }

    private void jump(Open parent, int direction, PriorityQueue<Open> open) {
        int column = parent.cell % cells.width;
        int row = parent.cell / cells.width;
        if ((direction & 1) == 0) {
            int end = straight(column, row, direction);
            if (end >= 0) {
                int c = DX[direction] != 0 ? end : column;
                int r = DX[direction] != 0 ? row : end;
                int steps = Math.abs(c - column) + Math.abs(r - row);
                arrive(r * cells.width + c, parent.reached + SIDE * steps, turns(c, r, direction), parent.cell, open);
            }
            return;
        }
        int dx = DX[direction];
        int dy = DY[direction];
        int c = column;
        int r = row;
        int cost = parent.reached;
        int alongX = dx > 0 ? 0 : 4;
        int alongY = dy > 0 ? 2 : 6;
        while (cells.isOpen(c + dx, r) && cells.isOpen(c, r + dy) && cells.isOpen(c + dx, r + dy)) {
            c += dx;
            r += dy;
            cost += DIAGONAL;
            boolean stop =
                    (c == goalColumn && r == goalRow) || straight(c, r, alongX) >= 0 || straight(c, r, alongY) >= 0;
            if (stop) {
                arrive(r * cells.width + c, cost, (1 << direction) | (1 << alongX) | (1 << alongY), parent.cell, open);
                return;
            }
        }
    }

    /// @return the column or row to stop at; −1 when there is nothing to stop for
    private int straight(int column, int row, int direction) {
        return DX[direction] != 0
                ? cells.alongRow(column, row, DX[direction], row == goalRow ? goalColumn : -1)
                : cells.alongColumn(column, row, DY[direction], column == goalColumn ? goalRow : -1);
    }

    /// Where a way that comes straight may go on: straight, and to each side that was closed one cell before.
    private int turns(int column, int row, int direction) {
        int turns = 1 << direction;
        int dx = DX[direction];
        int dy = DY[direction];
        for (int side = -2; side <= 2; side += 4) {
            int to = (direction + side) & 7;
            boolean closedBefore = !cells.isOpen(column - dx + DX[to], row - dy + DY[to]);
            if (closedBefore && cells.isOpen(column + DX[to], row + DY[to])) {
                turns |= (1 << to) | (1 << ((direction + side / 2) & 7));
            }
        }
        return turns;
    }

    /// A way comes to a cell and goes on from there in some directions, unless a shorter one was there, or one as
    /// long went on there.
    private void arrive(int cell, int cost, int directions, int parent, PriorityQueue<Open> open) {
        if (cost > reached[cell]) {
            return;
        }
        if (cost < reached[cell]) {
            if (reached[cell] == UNREACHED) {
                touched.add(cell);
            }
            reached[cell] = cost;
            from[cell] = parent;
            taken[cell] = 0;
        }
        int news = directions & ~taken[cell];
        if (news != 0) {
            taken[cell] |= (byte) news;
            open.add(new Open(cost + estimate(cell), cost, cell, news));
        }
    }

    /// The octile distance.
    private int estimate(int cell) {
        int dx = Math.abs(cell % cells.width - goalColumn);
        int dy = Math.abs(cell / cells.width - goalRow);
        return SIDE * Math.max(dx, dy) + (DIAGONAL - SIDE) * Math.min(dx, dy);
    }

    /// Where the way turns, start and goal included.
    private List<Point2d> points(int startCell, int goalCell) {
        var points = new ArrayList<Point2d>();
        for (int cell = goalCell; cell != startCell; cell = from[cell]) {
            points.add(grid.middle(cell));
        }
        points.add(grid.middle(startCell));
        Collections.reverse(points);
        return points;
    }

    /// Leaves out the points that the robot can pass by straight, again until there is none.
    private Path2d straight(List<Point2d> turns, Point2d start, Point2d goal) {
        var points = new ArrayList<>(turns);
        if (grid.cell(goal) == grid.cell(points.getLast())) {
            points.set(points.size() - 1, goal);
        }
        if (points.size() > 1 && grid.cell(start) == grid.cell(points.getFirst())) {
            points.set(0, start);
        } else {
            points.addFirst(start);
        }
        boolean shorter = true;
        while (shorter) {
            shorter = false;
            for (int i = points.size() - 2; i > 0; i--) {
                if (isStraight(points.get(i - 1), points.get(i + 1))) {
                    points.remove(i);
                    shorter = true;
                }
            }
        }
        return new Path2d(points);
    }

    private boolean isStraight(Point2d from, Point2d to) {
        if (!Double.isFinite(map.straightCost(from, to))) {
            return false;
        }
        int steps = blocked.isEmpty() ? 0 : (int) Math.ceil(2 * from.distanceTo(to) / grid.resolution());
        for (int i = 1; i < steps; i++) {
            double share = (double) i / steps;
            double x = from.x() + share * (to.x() - from.x());
            double y = from.y() + share * (to.y() - from.y());
            if (blocked.get(grid.row(y) * grid.width() + grid.column(x))) {
                return false;
            }
        }
        return true;
    }
}
