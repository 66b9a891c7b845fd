package rsal.testkit;

import java.util.ArrayList;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;

/// Distances to walls, the slow, obvious way: a ray is cut with the square of every occupied cell.
public final class ObviousRays {
    private final List<double[]> squares = new ArrayList<>(); // least x, least y, most x, most y

    public ObviousRays(OccupancyGrid grid) {
        for (int row = 0; row < grid.height(); row++) {
            for (int column = 0; column < grid.width(); column++) {
                if (grid.at(column, row) == OccupancyGrid.OCCUPIED) {
                    double x = grid.originX() + column * grid.resolution();
                    double y = grid.originY() + row * grid.resolution();
                    squares.add(new double[] {x, y, x + grid.resolution(), y + grid.resolution()});
                }
            }
        }
    }

    /// Distance along the x axis of a pose to the nearest wall [m]; +∞ when there is none.
    public double range(Pose2d mapFromSensor) {
        double dx = Math.cos(mapFromSensor.theta());
        double dy = Math.sin(mapFromSensor.theta());
        double nearest = Double.POSITIVE_INFINITY;
        for (double[] s : squares) {
            double enter = 0;
            double leave = nearest;
            if (Math.abs(dx) > 1e-12) {
                double a = (s[0] - mapFromSensor.x()) / dx;
                double b = (s[2] - mapFromSensor.x()) / dx;
                enter = Math.max(enter, Math.min(a, b));
                leave = Math.min(leave, Math.max(a, b));
            } else if (mapFromSensor.x() < s[0] || mapFromSensor.x() > s[2]) {
                continue;
            }
            if (Math.abs(dy) > 1e-12) {
                double a = (s[1] - mapFromSensor.y()) / dy;
                double b = (s[3] - mapFromSensor.y()) / dy;
                enter = Math.max(enter, Math.min(a, b));
                leave = Math.min(leave, Math.max(a, b));
            } else if (mapFromSensor.y() < s[1] || mapFromSensor.y() > s[3]) {
                continue;
            }
            if (enter <= leave) {
                nearest = Math.min(nearest, enter);
            }
        }
        return nearest;
    }

    /// Distance from a place to the nearest wall, whatever its direction [m]; +∞ when there is none.
    public double clearance(double x, double y) {
        double nearest = Double.POSITIVE_INFINITY;
        for (double[] s : squares) {
            double dx = Math.max(0, Math.max(s[0] - x, x - s[2]));
            double dy = Math.max(0, Math.max(s[1] - y, y - s[3]));
            nearest = Math.min(nearest, Math.hypot(dx, dy));
        }
        return nearest;
    }
}
