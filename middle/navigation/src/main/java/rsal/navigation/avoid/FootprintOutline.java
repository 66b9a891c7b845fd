package rsal.navigation.avoid;

import rsal.data.Footprint;
import rsal.data.Point2d;

/// A robot's outline as its sides, each pushed outwards by some room: how far points are from it, and when it comes
/// to them on its way. Immutable.
public final class FootprintOutline {
    private static final double STRAIGHT = 1e-4; // 1/m; less curved counts as straight

    private final double[] normalX; // outward, of each side
    private final double[] normalY;
    private final double[] offset; // of each side from the base along its normal [m]
    private final double[] cornerX; // where side i begins [m]
    private final double[] cornerY;
    private final double reach;

    /// @param room by which it is larger than the robot on all sides [m]
    public FootprintOutline(Footprint footprint, double room) {
        int n = footprint.corners().size();
        normalX = new double[n];
        normalY = new double[n];
        offset = new double[n];
        for (int i = 0; i < n; i++) {
            Point2d a = footprint.corners().get(i);
            Point2d b = footprint.corners().get((i + 1) % n);
            double length = a.distanceTo(b);
            normalX[i] = (b.y() - a.y()) / length;
            normalY[i] = (a.x() - b.x()) / length;
            offset[i] = normalX[i] * a.x() + normalY[i] * a.y() + room;
        }
        cornerX = new double[n];
        cornerY = new double[n];
        double farthest = 0;
        for (int i = 0; i < n; i++) {
            int before = (i + n - 1) % n;
            double cross = normalX[before] * normalY[i] - normalX[i] * normalY[before];
            cornerX[i] = (offset[before] * normalY[i] - offset[i] * normalY[before]) / cross;
            cornerY[i] = (normalX[before] * offset[i] - normalX[i] * offset[before]) / cross;
            farthest = Math.max(farthest, Math.hypot(cornerX[i], cornerY[i]));
        }
        reach = farthest;
    }

    /// Radius of the circle around the base that holds it [m].
    public double reach() {
        return reach;
    }

    /// Radius of a circle that covers as much as a footprint [m]: what a robot is for rules that know only circles.
    public static double radius(Footprint footprint) {
        double twice = 0;
        int n = footprint.corners().size();
        for (int i = 0; i < n; i++) {
            Point2d a = footprint.corners().get(i);
            Point2d b = footprint.corners().get((i + 1) % n);
            twice += a.x() * b.y() - a.y() * b.x();
        }
        return Math.sqrt(twice / 2 / Math.PI);
    }

    /// How far a point is from it [m], negative inside: the greatest distance from one of its sides, which beyond a
    /// corner is somewhat less than the true one.
    public double distance(double x, double y) {
        double distance = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < normalX.length; i++) {
            distance = Math.max(distance, normalX[i] * x + normalY[i] * y - offset[i]);
        }
        return distance;
    }

    /// How far the base gets forward on an arc until the outline meets a point [m], exactly; +∞ when it never does,
    /// 0 when the point is inside.
    ///
    /// @param curvature of the arc, positive to the left [1/m]
    public double freeDistance(double x, double y, double curvature) {
        if (distance(x, y) <= 0) {
            return 0;
        }
        return Math.abs(curvature) < STRAIGHT ? straight(x, y) : curved(x, y, 1 / curvature);
    }

    /// Seen from the robot the point comes straight towards it.
    private double straight(double x, double y) {
        double way = Double.POSITIVE_INFINITY;
        int n = cornerX.length;
        for (int i = 0; i < n; i++) {
            int next = (i + 1) % n;
            double from = cornerY[i] - y;
            double to = cornerY[next] - y;
            if ((from <= 0) != (to <= 0)) {
                double hit = cornerX[i] + (cornerX[next] - cornerX[i]) * from / (from - to);
                way = hit <= x ? Math.min(way, x - hit) : way;
            }
        }
        return way;
    }

    /// Seen from the robot the point goes around the center of the arc, against its sense.
    private double curved(double x, double y, double radius) {
        double distance = Math.hypot(x, y - radius);
        if (distance > Math.abs(radius) + reach || distance < Math.abs(radius) - reach) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.abs(radius) * around(x, y, radius, radius > 0 ? 1 : -1);
    }

    /// By what angle the robot turns around (0, centerY) until it meets a point [rad].
    private double around(double x, double y, double centerY, int direction) {
        double px = x;
        double py = y - centerY;
        double square = px * px + py * py;
        double start = Math.atan2(py, px);
        double least = Double.POSITIVE_INFINITY;
        int n = cornerX.length;
        for (int i = 0; i < n; i++) {
            int next = (i + 1) % n;
            double ax = cornerX[i];
            double ay = cornerY[i] - centerY;
            double dx = cornerX[next] - cornerX[i];
            double dy = cornerY[next] - cornerY[i];
            double a = dx * dx + dy * dy;
            double b = ax * dx + ay * dy;
            double discriminant = b * b - a * (ax * ax + ay * ay - square);
            if (discriminant < 0) {
                continue;
            }
            double root = Math.sqrt(discriminant);
            for (int sign = -1; sign <= 1; sign += 2) {
                double share = (sign * root - b) / a;
                if (share >= 0 && share <= 1) {
                    double angle = direction * (start - Math.atan2(ay + share * dy, ax + share * dx));
                    least = Math.min(least, angle < 0 ? angle + 2 * Math.PI : angle);
                }
            }
        }
        return least;
    }
}
