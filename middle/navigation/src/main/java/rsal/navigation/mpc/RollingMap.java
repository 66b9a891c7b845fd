package rsal.navigation.mpc;

import java.util.Arrays;
import rsal.data.DistanceTransform;
import rsal.data.Pose2d;
import rsal.navigation.avoid.Obstacles;

/// What was seen around a robot, in cells of its odometry frame that move along with it: evidence grows where
/// something is seen and shrinks where one sees through (log odds: H. Moravec, A. Elfes, High Resolution Maps from
/// Wide Angle Sonar, 1985). What was never seen counts as free, and what was not seen for long is forgotten.
final class RollingMap {
    private static final float HIT = 1.0f;
    private static final float MISS = 0.35f;
    private static final float SUREST = 3.5f;
    private static final float LEAST = -1.5f;
    private static final double BEFORE = 0.12; // m before a hit that are not said to be free
    private static final double KEPT_IN_MIDDLE = 1.0; // m; farther from the middle the map moves

    private final int side;
    private final double resolution;
    private final float fading;
    private float[] evidence;
    private float[] spare;
    private final float[] distances;
    private double left;
    private double bottom;
    private boolean empty = true;

    /// @param side cells
    /// @param resolution side of a cell [m]
    /// @param notes after how many times what is not seen again is forgotten
    RollingMap(int side, double resolution, double notes) {
        this.side = side;
        this.fading = (float) (SUREST / notes);
        this.resolution = resolution;
        this.evidence = new float[side * side];
        this.spare = new float[side * side];
        this.distances = new float[side * side];
    }

    int side() {
        return side;
    }

    double resolution() {
        return resolution;
    }

    void reset() {
        empty = true;
    }

    /// Notes what is seen now.
    void note(Obstacles obstacles, Pose2d odomFromBase) {
        follow(odomFromBase);
        clear(obstacles, odomFromBase);
        double cos = Math.cos(odomFromBase.theta());
        double sin = Math.sin(odomFromBase.theta());
        for (int i = 0; i < obstacles.count(); i++) {
            double x = obstacles.x(i);
            double y = obstacles.y(i);
            int cell = cell(odomFromBase.x() + cos * x - sin * y, odomFromBase.y() + sin * x + cos * y);
            if (cell >= 0) {
                evidence[cell] = Math.clamp(evidence[cell] + HIT, HIT, SUREST);
            }
        }
        measure();
    }

    private void follow(Pose2d odomFromBase) {
        double half = side * resolution / 2;
        if (empty) {
            Arrays.fill(evidence, 0);
            left = resolution * Math.floor((odomFromBase.x() - half) / resolution);
            bottom = resolution * Math.floor((odomFromBase.y() - half) / resolution);
            empty = false;
            return;
        }
        double offX = odomFromBase.x() - left - half;
        double offY = odomFromBase.y() - bottom - half;
        if (Math.max(Math.abs(offX), Math.abs(offY)) > KEPT_IN_MIDDLE) {
            shift((int) Math.round(offX / resolution), (int) Math.round(offY / resolution));
        }
    }

    private void shift(int columns, int rows) {
        Arrays.fill(spare, 0);
        int length = side - Math.abs(columns);
        for (int row = Math.max(0, -rows); length > 0 && row < Math.min(side, side - rows); row++) {
            int from = (row + rows) * side + Math.max(0, columns);
            System.arraycopy(evidence, from, spare, row * side + Math.max(0, -columns), length);
        }
        float[] old = evidence;
        evidence = spare;
        spare = old;
        left += columns * resolution;
        bottom += rows * resolution;
    }

    /// Lowers the evidence of what is seen through, for every direction of sight.
    private void clear(Obstacles obstacles, Pose2d odomFromBase) {
        for (int i = 0; i < Obstacles.SIGHTS; i++) {
            double far = Math.min(obstacles.sight(i) - BEFORE, side * resolution / 2);
            double direction = odomFromBase.theta() + 2 * Math.PI * i / Obstacles.SIGHTS;
            double dx = Math.cos(direction);
            double dy = Math.sin(direction);
            int last = -1;
            for (double way = 0; way < far; way += resolution) {
                int cell = cell(odomFromBase.x() + way * dx, odomFromBase.y() + way * dy);
                if (cell < 0) {
                    break;
                }
                if (cell != last && evidence[cell] > LEAST) {
                    evidence[cell] -= MISS;
                }
                last = cell;
            }
        }
    }

    private void measure() {
        DistanceTransform.measure(side, side, this::isOccupied, (row, squares) -> {
            for (int column = 0; column < side; column++) {
                distances[row * side + column] = (float) (resolution * Math.sqrt(squares[column]));
            }
        });
    }

    private boolean isOccupied(int cell) {
        if (evidence[cell] <= 0) {
            return false;
        }
        evidence[cell] -= fading;
        return true;
    }

    /// The cell of a place in the odometry frame; −1 outside.
    int cell(double x, double y) {
        int column = (int) Math.floor((x - left) / resolution);
        int row = (int) Math.floor((y - bottom) / resolution);
        return column >= 0 && column < side && row >= 0 && row < side ? row * side + column : -1;
    }

    /// x of the middle of a column in the odometry frame [m].
    double x(int column) {
        return left + (column + 0.5) * resolution;
    }

    /// y of the middle of a row in the odometry frame [m].
    double y(int row) {
        return bottom + (row + 0.5) * resolution;
    }

    /// How far the next obstacle is from a cell [m].
    float distance(int cell) {
        return distances[cell];
    }

    /// How far the next obstacle is from a place in the odometry frame [m]; +∞ outside.
    float distance(double x, double y) {
        int cell = cell(x, y);
        return cell < 0 ? Float.POSITIVE_INFINITY : distances[cell];
    }
}
