package rsal.navigation.scanmatch;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

/// A world of straight walls, and what a laser would measure in it.
public final class Walls {
    private final List<double[]> walls = new ArrayList<>();

    /// A chain of walls through points x, y [m].
    public Walls chain(double... points) {
        for (int i = 0; i + 3 < points.length; i += 2) {
            walls.add(new double[] {points[i], points[i + 1], points[i + 2], points[i + 3]});
        }
        return this;
    }

    /// A box [m].
    public Walls box(double left, double bottom, double right, double top) {
        return chain(left, bottom, right, bottom, right, top, left, top, left, bottom);
    }

    /// A room of 8 m × 6 m with corners, a pillar and a niche.
    public static Walls room() {
        return new Walls()
                .chain(0, 0, 8, 0, 8, 3.5, 8.7, 3.5, 8.7, 4.2, 8, 4.2, 8, 6, 2, 6, 2, 5, 0, 5, 0, 0)
                .box(5, 1.5, 5.5, 2);
    }

    /// Half a turn ahead, a beam for each degree.
    public LaserScan scan(Pose2d mapFromBase, double deviation, RandomGenerator random) {
        var ranges = new float[181];
        for (int i = 0; i < ranges.length; i++) {
            double range = cast(mapFromBase, Math.toRadians(i - 90.0)) + deviation * random.nextGaussian();
            ranges[i] = range <= 30 ? (float) range : Float.POSITIVE_INFINITY;
        }
        return new LaserScan(Pose2d.ORIGIN, -Math.PI / 2, Math.toRadians(1), 0, 30, ranges);
    }

    private double cast(Pose2d from, double bearing) {
        double dx = Math.cos(from.theta() + bearing);
        double dy = Math.sin(from.theta() + bearing);
        double nearest = Double.POSITIVE_INFINITY;
        for (double[] wall : walls) {
            double alongX = wall[2] - wall[0];
            double alongY = wall[3] - wall[1];
            double toX = wall[0] - from.x();
            double toY = wall[1] - from.y();
            double cross = dx * alongY - dy * alongX;
            double range = (toX * alongY - toY * alongX) / cross;
            double share = (toX * dy - toY * dx) / cross;
            if (range > 0 && share >= 0 && share <= 1) { // not parallel
                nearest = Math.min(nearest, range);
            }
        }
        return nearest;
    }
}
