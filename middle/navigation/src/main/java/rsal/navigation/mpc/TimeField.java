package rsal.navigation.mpc;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import rsal.data.Point2d;

/// How long the way takes from each cell of a [RollingMap] [s], when near obstacles one drives slowly: the solution
/// of the eikonal equation by fast marching (J. Sethian, A Fast Marching Level Set Method for Monotonically
/// Advancing Fronts, PNAS 93, 1996) with a queue of buckets (L. Yatziv, A. Bartesaghi, G. Sapiro, O(N)
/// Implementation of the Fast Marching Algorithm, J. Comput. Phys. 212, 2006).
final class TimeField {
    private static final float UNREACHED = Float.POSITIVE_INFINITY;
    private static final int BUCKETS = 1 << 11;
    private static final double STEP = 0.01; // m; of distances that speeds are kept for
    private static final int STEPS = 200;
    private static final float BEYOND = 3; // s

    private final RollingMap map;
    private final int side;
    private final float[] times;
    private final boolean[] done;
    private final float[] slowness = new float[STEPS]; // s/m
    private final double span; // of a bucket [s]
    private final int[][] buckets = new int[BUCKETS][16];
    private final int[] filled = new int[BUCKETS];
    private int waiting;

    /// @param speeds how fast one may be [m/s] where the next obstacle is so far from the base [m]; 0 where the
    /// robot can't be
    TimeField(RollingMap map, DoubleUnaryOperator speeds) {
        this.map = map;
        this.side = map.side();
        this.times = new float[side * side];
        this.done = new boolean[side * side];
        for (int i = 0; i < STEPS; i++) {
            double speed = speeds.applyAsDouble((i + 0.5) * STEP);
            slowness[i] = speed > 0 ? (float) (1 / speed) : UNREACHED;
        }
        this.span = 3.0 * side * map.resolution() * slowness[STEPS - 1] / BUCKETS;
    }

    private float slowness(int cell) {
        float distance = map.distance(cell);
        return distance >= STEPS * STEP ? slowness[STEPS - 1] : slowness[(int) (distance / STEP)];
    }

    /// Lets the wave spread from a place in the odometry frame; from the map's border, when it is outside, as if
    /// nothing were beyond. It ends some time after it came to the robot: farther away nobody asks.
    void spread(Point2d goal, Point2d robot) {
        Arrays.fill(times, UNREACHED);
        Arrays.fill(done, false);
        Arrays.fill(filled, 0);
        waiting = 0;
        int cell = map.cell(goal.x(), goal.y());
        if (cell >= 0) {
            seed(cell, 0);
        } else {
            double nearest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < 4 * side; i++) {
                nearest = Math.min(nearest, beyond(border(i), goal));
            }
            for (int i = 0; i < 4 * side; i++) {
                if (slowness(border(i)) < UNREACHED) {
                    seed(border(i), (float) (beyond(border(i), goal) - nearest));
                }
            }
        }
        march(map.cell(robot.x(), robot.y()));
    }

    private int border(int i) {
        int along = i % side;
        return switch (i / side) {
            case 0 -> along;
            case 1 -> (side - 1) * side + along;
            case 2 -> along * side;
            default -> along * side + side - 1;
        };
    }

    /// From a cell straight to a goal outside [s].
    private double beyond(int cell, Point2d goal) {
        return Math.hypot(map.x(cell % side) - goal.x(), map.y(cell / side) - goal.y()) * slowness[STEPS - 1];
    }

    private void seed(int cell, float time) {
        if (time < times[cell]) {
            times[cell] = time;
            add(cell, time);
        }
    }

    private void add(int cell, float time) {
        int bucket = (int) (time / span) & (BUCKETS - 1);
        int count = filled[bucket];
        if (count == buckets[bucket].length) {
            buckets[bucket] = Arrays.copyOf(buckets[bucket], 2 * count);
        }
        buckets[bucket][count] = cell;
        filled[bucket]++;
        waiting++;
    }

    private void march(int robot) {
        float last = UNREACHED;
        for (int bucket = 0; waiting > 0; bucket = (bucket + 1) & (BUCKETS - 1)) {
            while (filled[bucket] > 0) {
                filled[bucket]--;
                waiting--;
                int cell = buckets[bucket][filled[bucket]];
                if (times[cell] > last) {
                    return;
                }
                if (!done[cell]) {
                    done[cell] = true;
                    reachNeighbors(cell);
                }
                if (cell == robot) {
                    last = times[cell] + BEYOND;
                }
            }
        }
    }

    private void reachNeighbors(int cell) {
        int column = cell % side;
        int row = cell / side;
        if (column > 0) {
            reach(cell - 1, column - 1, row);
        }
        if (column < side - 1) {
            reach(cell + 1, column + 1, row);
        }
        if (row > 0) {
            reach(cell - side, column, row - 1);
        }
        if (row < side - 1) {
            reach(cell + side, column, row + 1);
        }
    }

    private void reach(int cell, int column, int row) {
        float slow = slowness(cell);
        if (done[cell] || slow == UNREACHED) {
            return;
        }
        double step = slow * map.resolution();
        double beside =
                Math.min(column > 0 ? times[cell - 1] : UNREACHED, column < side - 1 ? times[cell + 1] : UNREACHED);
        double above =
                Math.min(row > 0 ? times[cell - side] : UNREACHED, row < side - 1 ? times[cell + side] : UNREACHED);
        double difference = Math.abs(beside - above);
        double time = difference < step
                ? (beside + above + Math.sqrt(2 * step * step - difference * difference)) / 2
                : Math.min(beside, above) + step;
        if (time < times[cell]) {
            times[cell] = (float) time;
            add(cell, (float) time);
        }
    }

    /// From a place in the odometry frame [s], linear between the middles of cells; +∞ where no way leads.
    double at(double x, double y) {
        double u = (x - map.x(0)) / map.resolution();
        double v = (y - map.y(0)) / map.resolution();
        int column = (int) Math.floor(u);
        int row = (int) Math.floor(v);
        if (column < 0 || row < 0 || column >= side - 1 || row >= side - 1) {
            return UNREACHED;
        }
        int cell = row * side + column;
        double nearest =
                Math.min(Math.min(times[cell], times[cell + 1]), Math.min(times[cell + side], times[cell + side + 1]));
        double none = nearest + 1; // s; of those of the four that can't be reached
        double a = Math.min(times[cell], none);
        double b = Math.min(times[cell + 1], none);
        double c = Math.min(times[cell + side], none);
        double d = Math.min(times[cell + side + 1], none);
        double shareX = u - column;
        double shareY = v - row;
        return nearest == UNREACHED
                ? UNREACHED
                : (1 - shareY) * ((1 - shareX) * a + shareX * b) + shareY * ((1 - shareX) * c + shareX * d);
    }

    /// Where the way leads from a place in the odometry frame [rad]; NaN where none does.
    double direction(double x, double y) {
        double h = 1.5 * map.resolution();
        double dx = at(x + h, y) - at(x - h, y);
        double dy = at(x, y + h) - at(x, y - h);
        return Double.isFinite(dx) && Double.isFinite(dy) && (dx != 0 || dy != 0) ? Math.atan2(-dy, -dx) : Double.NaN;
    }
}
