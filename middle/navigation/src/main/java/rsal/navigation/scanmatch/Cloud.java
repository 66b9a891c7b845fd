package rsal.navigation.scanmatch;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

/// What a laser hit, as points in one frame, each with the direction in which the surface there faces, where
/// that can be told from its neighbors. Immutable.
public final class Cloud {
    /// Points of a scan of which none is drawn are none.
    public static final Cloud EMPTY = new Cloud(0);

    private static final int MOST_NEIGHBORS = 25; // beams to either side
    private static final double NEAR = 0.5; // m; neighbors, or half of that where they bend
    private static final double BEAMS = 3; // so many beams apart
    private static final double GAP = 0.2; // m; between neighbors, besides two beams
    private static final double THIN = 0.03; // m; how far neighbors are off their line
    private static final double LONG = 2.5; // their length by that

    final double[] x;
    final double[] y;
    final double[] normalX; // NaN where there is none
    final double[] normalY;

    private Cloud(int count) {
        x = new double[count];
        y = new double[count];
        normalX = new double[count];
        normalY = new double[count];
    }

    /// The hits of a scan within a range in meters, in the frame of the robot.
    public static Cloud of(LaserScan scan, double maxRange) {
        Pose2d baseFromLaser = scan.baseFromLaser();
        var cloud = new Cloud(scan.count());
        var range = new double[scan.count()];
        int count = 0;
        for (int i = 0; i < scan.count(); i++) {
            if (scan.isHit(i) && scan.ranges()[i] <= maxRange) {
                double direction = baseFromLaser.theta() + scan.angle(i);
                range[count] = scan.ranges()[i];
                cloud.x[count] = baseFromLaser.x() + range[count] * Math.cos(direction);
                cloud.y[count] = baseFromLaser.y() + range[count] * Math.sin(direction);
                count++;
            }
        }
        var hits = cloud.first(count);
        for (int i = 0; i < count; i++) {
            double apart = range[i] * Math.abs(scan.angleIncrement());
            if (!hits.findNormal(i, Math.max(NEAR, BEAMS * apart), GAP + 2 * apart)) {
                hits.findNormal(i, Math.max(NEAR / 2, BEAMS * apart), GAP + 2 * apart);
            }
            hits.turnNormal(i, baseFromLaser);
        }
        return hits;
    }

    /// The direction in which the neighbors of a point scatter least, if they lie on a line.
    private boolean findNormal(int point, double near, double gap) {
        int first = point;
        while (first > 0
                && point - first < MOST_NEIGHBORS
                && isNear(first, first - 1, gap)
                && isNear(point, first - 1, near)) {
            first--;
        }
        int last = point;
        while (last < x.length - 1
                && last - point < MOST_NEIGHBORS
                && isNear(last, last + 1, gap)
                && isNear(point, last + 1, near)) {
            last++;
        }
        int count = last - first + 1;
        double meanX = 0;
        double meanY = 0;
        for (int i = first; i <= last; i++) {
            meanX += x[i] / count;
            meanY += y[i] / count;
        }
        double xx = 0;
        double xy = 0;
        double yy = 0;
        for (int i = first; i <= last; i++) {
            xx += (x[i] - meanX) * (x[i] - meanX);
            xy += (x[i] - meanX) * (y[i] - meanY);
            yy += (y[i] - meanY) * (y[i] - meanY);
        }
        double middle = (xx + yy) / 2;
        double spread = Math.hypot((xx - yy) / 2, xy);
        double thickness = Math.sqrt(Math.max(0, middle - spread) / count);
        double length = Math.sqrt((middle + spread) / count);
        boolean straight = count >= 3 && thickness < THIN && length > LONG * thickness;
        double along = 0.5 * Math.atan2(2 * xy, xx - yy);
        normalX[point] = straight ? -Math.sin(along) : Double.NaN;
        normalY[point] = straight ? Math.cos(along) : Double.NaN;
        return straight;
    }

    /// Turns it to where it was seen from: walls have two sides.
    private void turnNormal(int point, Pose2d eye) {
        boolean away = normalX[point] * (eye.x() - x[point]) + normalY[point] * (eye.y() - y[point]) < 0;
        normalX[point] *= away ? -1 : 1;
        normalY[point] *= away ? -1 : 1;
    }

    private boolean isNear(int a, int b, double within) {
        double dx = x[a] - x[b];
        double dy = y[a] - y[b];
        return dx * dx + dy * dy < within * within;
    }

    private Cloud first(int count) {
        var part = new Cloud(count);
        System.arraycopy(x, 0, part.x, 0, count);
        System.arraycopy(y, 0, part.y, 0, count);
        System.arraycopy(normalX, 0, part.normalX, 0, count);
        System.arraycopy(normalY, 0, part.normalY, 0, count);
        return part;
    }

    /// How many points there are.
    public int count() {
        return x.length;
    }

    public double x(int point) {
        return x[point];
    }

    public double y(int point) {
        return y[point];
    }

    /// The direction in which the surface at a point faces, as a unit vector; NaN where there is none.
    public double normalX(int point) {
        return normalX[point];
    }

    public double normalY(int point) {
        return normalY[point];
    }

    /// The same points in another frame.
    ///
    /// @param aFromB where the frame of these points is in the new one
    public Cloud movedBy(Pose2d aFromB) {
        var moved = new Cloud(count());
        double cos = Math.cos(aFromB.theta());
        double sin = Math.sin(aFromB.theta());
        for (int i = 0; i < count(); i++) {
            moved.x[i] = aFromB.x() + cos * x[i] - sin * y[i];
            moved.y[i] = aFromB.y() + sin * x[i] + cos * y[i];
            moved.normalX[i] = cos * normalX[i] - sin * normalY[i];
            moved.normalY[i] = sin * normalX[i] + cos * normalY[i];
        }
        return moved;
    }

    /// All points of several clouds in the same frame.
    public static Cloud joined(List<Cloud> clouds) {
        var joined = new Cloud(clouds.stream().mapToInt(Cloud::count).sum());
        int next = 0;
        for (Cloud cloud : clouds) {
            System.arraycopy(cloud.x, 0, joined.x, next, cloud.count());
            System.arraycopy(cloud.y, 0, joined.y, next, cloud.count());
            System.arraycopy(cloud.normalX, 0, joined.normalX, next, cloud.count());
            System.arraycopy(cloud.normalY, 0, joined.normalY, next, cloud.count());
            next += cloud.count();
        }
        return joined;
    }

    /// The first point in each cell of a grid, so that near surfaces, which are hit by most beams, don't
    /// count more than far ones.
    ///
    /// @param cell its side in meters
    public Cloud thinned(double cell) {
        var taken = new HashSet<Long>();
        var thin = new Cloud(count());
        int next = 0;
        for (int i = 0; i < count(); i++) {
            long column = (long) Math.floor(x[i] / cell);
            long row = (long) Math.floor(y[i] / cell);
            if (taken.add((column << 32) ^ (row & 0xffffffffL))) {
                thin.x[next] = x[i];
                thin.y[next] = y[i];
                thin.normalX[next] = normalX[i];
                thin.normalY[next] = normalY[i];
                next++;
            }
        }
        return thin.first(next);
    }

    /// Distance of the farthest point from the frame's origin in meters.
    double reach() {
        double most = 0;
        for (int i = 0; i < count(); i++) {
            most = Math.max(most, Math.hypot(x[i], y[i]));
        }
        return most;
    }

    double least(boolean ofX) {
        return Arrays.stream(ofX ? x : y).min().orElse(0);
    }

    double most(boolean ofX) {
        return Arrays.stream(ofX ? x : y).max().orElse(0);
    }
}
