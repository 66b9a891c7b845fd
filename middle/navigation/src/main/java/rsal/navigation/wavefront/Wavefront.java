package rsal.navigation.wavefront;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;

/// Finds the cheapest way over a [CostMap]: a wave spreads from the goal over the eight neighbors of each cell
/// and leaves in each cell what the way to the goal costs from there (the navigation function NF1 of J.-C.
/// Latombe, Robot Motion Planning, 1991, with costs). The way follows it downhill and is then pulled straight.
///
/// The wave is ordered by R. Dial's buckets (Algorithm 360, CACM 12, 1969), since costs are small whole numbers.
/// It hurries towards the start by the octile distance (P. Hart, N. Nilsson, B. Raphael, 1968) and ends there.
///
/// Keeps nothing between plans, so it may be asked on any thread.
public final class Wavefront {
    /// The value of a cell that the wave did not reach.
    static final int UNREACHED = Integer.MAX_VALUE;

    private static final int DIAGONAL = 14; // where a side is CostMap.STRAIGHT
    private static final int BUCKETS = 128; // a power of 2, more than a step and its gain towards the start cost
    private static final double ESCAPE = 1.0; // m; so far a robot may have got where it may not be
    private static final double NO_DEARER = 1.02;
    private static final int STRIDE = 4; // cells; how closely corners are looked for

    private final CostMap map;
    private final int width;
    private final byte[] costs;

    public Wavefront(CostMap map) {
        this.map = map;
        this.width = map.grid().width();
        this.costs = map.costs();
    }

    /// Plans a way. A start too near to obstacles is left by the shortest way. A goal too near to obstacles is
    /// replaced by the nearest place that is not, when that is no farther than `slack` [m] away.
    public Plan plan(Point2d start, Point2d goal, double slack) {
        OccupancyGrid grid = map.grid();
        if (!grid.contains(grid.column(goal.x()), grid.row(goal.y()))) {
            return none("The goal %s is outside the map.", goal);
        }
        if (!grid.contains(grid.column(start.x()), grid.row(start.y()))) {
            return none("The start %s is outside the map.", start);
        }
        if (!grid.isFree(goal.x(), goal.y())) {
            return none("The goal %s is in a wall or where the map knows nothing.", goal);
        }
        int goalCell = nearestPassable(goal, slack);
        if (goalCell < 0) {
            return none("The goal %s is too near to an obstacle for this robot.", goal);
        }
        int startCell = nearestPassable(start, ESCAPE);
        if (startCell < 0) {
            return none("The robot at %s is shut in between obstacles.", start);
        }
        int[] field = field(goalCell, startCell);
        if (field[startCell] == UNREACHED) {
            return none("Nothing this robot fits through leads to the goal %s.", goal);
        }
        var points = new ArrayList<Point2d>();
        points.add(start);
        if (!map.isPassable(start)) {
            points.add(middle(startCell)); // out of the obstacle's reach first
        }
        pullStraight(downhill(field, startCell), field, points);
        if (map.isPassable(goal)) {
            points.set(points.size() - 1, goal);
        }
        double cost = field[startCell] * grid.resolution() / CostMap.STRAIGHT;
        return new Plan.Found(new Path2d(points), cost + start.distanceTo(middle(startCell)));
    }

    /// What the way to the goal costs from each cell, where a side of a cell far from everything costs
    /// [CostMap#STRAIGHT]; for all cells that the wave reached before it came to the start.
    ///
    /// @param startCell −1 lets the wave reach everything
    int[] field(int goalCell, int startCell) {
        var field = new int[costs.length];
        Arrays.fill(field, UNREACHED);
        var done = new boolean[costs.length];
        var wave = new Buckets();
        int startColumn = startCell % width;
        int startRow = startCell / width;
        int[] neighbors = {-1, 1, -width, width, -width - 1, -width + 1, width - 1, width + 1};
        field[goalCell] = 0;
        wave.add(estimate(goalCell, startColumn, startRow, startCell), goalCell);
        for (int cell = wave.next(); cell >= 0; cell = wave.next()) {
            if (done[cell]) {
                continue;
            }
            done[cell] = true;
            if (cell == startCell) {
                break;
            }
            boolean left = costs[cell - 1] != CostMap.BLOCKED;
            boolean right = costs[cell + 1] != CostMap.BLOCKED;
            boolean below = costs[cell - width] != CostMap.BLOCKED;
            boolean above = costs[cell + width] != CostMap.BLOCKED;
            for (int way = 0; way < 8; way++) {
                boolean open = switch (way) {
                    case 0 -> left;
                    case 1 -> right;
                    case 2 -> below;
                    case 3 -> above;
                    case 4 -> left && below; // no squeezing through between two corners
                    case 5 -> right && below;
                    case 6 -> left && above;
                    default -> right && above;
                };
                int next = cell + neighbors[way];
                if (!open || done[next] || costs[next] == CostMap.BLOCKED) {
                    continue;
                }
                int reached = field[cell] + step(next, way >= 4);
                if (reached < field[next]) {
                    field[next] = reached;
                    wave.add(reached + estimate(next, startColumn, startRow, startCell), next);
                }
            }
        }
        return field;
    }

    /// The cell of a place that the robot may be at, or the nearest such cell; −1 when none is so near.
    int nearestPassable(Point2d place, double within) {
        OccupancyGrid grid = map.grid();
        int column = grid.column(place.x());
        int row = grid.row(place.y());
        int reach = (int) Math.ceil(within / grid.resolution());
        int nearest = -1;
        double best = Double.POSITIVE_INFINITY;
        for (int r = Math.max(0, row - reach); r <= Math.min(grid.height() - 1, row + reach); r++) {
            for (int c = Math.max(0, column - reach); c <= Math.min(width - 1, column + reach); c++) {
                boolean here = c == column && r == row;
                double distance = here ? 0 : Math.hypot(grid.x(c) - place.x(), grid.y(r) - place.y());
                if (costs[r * width + c] != CostMap.BLOCKED && distance <= within && distance < best) {
                    best = distance;
                    nearest = r * width + c;
                }
            }
        }
        return nearest;
    }

    private int step(int into, boolean diagonal) {
        return diagonal ? costs[into] * DIAGONAL / CostMap.STRAIGHT : costs[into];
    }

    /// Never more than the way from here to the start really costs.
    private int estimate(int cell, int startColumn, int startRow, int startCell) {
        if (startCell < 0) {
            return 0;
        }
        int row = cell / width;
        int dx = Math.abs(cell - row * width - startColumn);
        int dy = Math.abs(row - startRow);
        return CostMap.STRAIGHT * Math.max(dx, dy) + (DIAGONAL - CostMap.STRAIGHT) * Math.min(dx, dy);
    }

    private int[] downhill(int[] field, int startCell) {
        var cells = new int[64];
        int count = 0;
        int cell = startCell;
        while (true) {
            if (count == cells.length) {
                cells = Arrays.copyOf(cells, 2 * count);
            }
            cells[count++] = cell;
            if (field[cell] == 0) {
                return Arrays.copyOf(cells, count);
            }
            cell = nextDownhill(field, cell);
        }
    }

    /// The neighbor from which the wave came.
    private int nextDownhill(int[] field, int cell) {
        int best = -1;
        int least = UNREACHED;
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                int next = cell + dy * width + dx;
                boolean corner = dx != 0
                        && dy != 0
                        && (costs[cell + dx] == CostMap.BLOCKED || costs[cell + dy * width] == CostMap.BLOCKED);
                if ((dx == 0 && dy == 0) || corner || field[next] >= field[cell]) {
                    continue;
                }
                int through = field[next] + step(cell, dx != 0 && dy != 0);
                if (through < least) {
                    least = through;
                    best = next;
                }
            }
        }
        return best;
    }

    /// Leaves out the cells that a straight line may skip without being dearer.
    private void pullStraight(int[] cells, int[] field, List<Point2d> points) {
        int last = cells.length - 1;
        int anchor = 0;
        while (anchor < last) {
            int reached = anchor + 1;
            int next = Math.min(anchor + STRIDE, last);
            while (next > reached && isStraight(field, cells[anchor], cells[next])) {
                reached = next;
                next = Math.min(next + STRIDE, last);
            }
            anchor = reached;
            points.add(middle(cells[anchor]));
        }
        if (last == 0) {
            points.add(middle(cells[0]));
        }
    }

    private boolean isStraight(int[] field, int from, int to) {
        double along = (field[from] - field[to]) * map.grid().resolution() / CostMap.STRAIGHT;
        return map.straightCost(middle(from), middle(to)) <= along * NO_DEARER;
    }

    private Point2d middle(int cell) {
        return new Point2d(map.grid().x(cell % width), map.grid().y(cell / width));
    }

    private static Plan.None none(String why, Point2d place) {
        return new Plan.None(why.formatted(String.format(Locale.ROOT, "(%.2f, %.2f)", place.x(), place.y())));
    }

    /// Cells in the order of their costs; equal ones in the order opposite to that in which they came.
    private static final class Buckets {
        private final int[][] cells = new int[BUCKETS][256];
        private final int[] counts = new int[BUCKETS];
        private int size;
        private int cost;
        private boolean started;

        void add(int at, int cell) {
            if (!started) {
                cost = at;
                started = true;
            }
            int bucket = at & BUCKETS - 1;
            if (counts[bucket] == cells[bucket].length) {
                cells[bucket] = Arrays.copyOf(cells[bucket], 2 * counts[bucket]);
            }
            cells[bucket][counts[bucket]++] = cell;
            size++;
        }

        int next() {
            if (size == 0) {
                return -1;
            }
            while (counts[cost & BUCKETS - 1] == 0) {
                cost++;
            }
            size--;
            return cells[cost & BUCKETS - 1][--counts[cost & BUCKETS - 1]];
        }
    }
}
