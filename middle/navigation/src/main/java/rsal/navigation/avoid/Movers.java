package rsal.navigation.avoid;

import java.time.Instant;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

/// People, robots and others that move: groups of beams that end where the map has nothing, followed from scan to scan.
/// Each is taken to go on as it does (constant velocity). Places and velocities are estimated by alpha-beta filters
/// whose
/// gains are those of a least-squares line through all scans at first (Bar-Shalom, Li, Kirubarajan: Estimation with
/// Applications to Tracking and Navigation, 2001, section 6.5), later fixed ones. In the odometry frame, so that a
/// localizer's jumps move nobody.
///
/// Differs from common trackers in that a group goes to the nearest track, first come, first served: bodies do not
/// cross
/// each other.
///
/// Keeps its arrays, so each robot needs its own, on one thread.
public final class Movers {
    private static final int MOST = 24;
    private static final double RANGE = 6; // m
    private static final double GAP = 0.2; // m between points of two bodies
    private static final double LARGEST = 1.0; // m across; what is larger is furniture
    private static final int LEAST_POINTS = 3; // a single beam may be wrong
    private static final double GATE = 0.4; // m between where one was expected and is seen
    private static final double MEMORY = 0.6; // s for which one is expected that is not seen
    private static final double SLOWEST = 0.25; // m/s; the edges of what stands seem to move, too
    private static final double MOVED = 0.2; // m from where it was seen first
    private static final int SEEN = 4; // scans
    private static final double ALPHA = 0.4;
    private static final double BETA = 0.1;
    private static final int PREDICTED = 3; // places
    private static final double PREDICTED_STEP = 0.35; // s
    private static final double LEAST_RADIUS = 0.15; // m

    private final double[] x = new double[MOST]; // odometry frame
    private final double[] y = new double[MOST];
    private final double[] vx = new double[MOST];
    private final double[] vy = new double[MOST];
    private final double[] firstX = new double[MOST];
    private final double[] firstY = new double[MOST];
    private final double[] radius = new double[MOST];
    private final double[] missed = new double[MOST]; // s since it was seen
    private final int[] hits = new int[MOST];
    private final boolean[] seen = new boolean[MOST]; // in this scan
    private int tracks;
    private Instant last = Instant.MIN;
    private Pose2d baseFromOdom = Pose2d.ORIGIN;
    private final int[] moving = new int[MOST];
    private final double[] baseX = new double[MOST];
    private final double[] baseY = new double[MOST];
    private final double[] baseVx = new double[MOST];
    private final double[] baseVy = new double[MOST];
    private int count;

    private double startX; // of the group of beams that is read, in the odometry frame
    private double startY;
    private double endX;
    private double endY;
    private int points;

    /// Whether the map explains that something is at a place.
    @FunctionalInterface
    public interface KnownPlaces {
        /// @param x map frame [m]
        /// @param range from the sensor [m]; the farther, the more noise
        boolean contains(double x, double y, double range);
    }

    /// Takes a new scan; the same one again only moves the robot.
    public void see(LaserScan scan, Instant time, Pose2d odomFromBase, Pose2d mapFromBase, KnownPlaces known) {
        baseFromOdom = odomFromBase.inverse();
        if (time.isAfter(last)) {
            double step = last.equals(Instant.MIN) ? 1 : (time.toEpochMilli() - last.toEpochMilli()) / 1000.0;
            last = time;
            expect(step);
            read(scan, odomFromBase, mapFromBase, known, step);
            forget();
        }
        list();
    }

    private void expect(double step) {
        for (int i = 0; i < tracks; i++) {
            x[i] += vx[i] * step;
            y[i] += vy[i] * step;
            missed[i] += step;
            seen[i] = false;
        }
    }

    private void read(LaserScan scan, Pose2d odomFromBase, Pose2d mapFromBase, KnownPlaces known, double step) {
        Pose2d odomFromLaser = odomFromBase.compose(scan.baseFromLaser());
        Pose2d mapFromLaser = mapFromBase.compose(scan.baseFromLaser());
        points = 0;
        for (int beam = 0; beam < scan.count(); beam++) {
            double range = scan.distance(beam);
            boolean isHit = range > 0 && range <= Math.min(RANGE, scan.rangeMax()) && scan.isHit(beam);
            double direction = mapFromLaser.theta() + scan.angle(beam);
            boolean isStrange = isHit
                    && !known.contains(
                            mapFromLaser.x() + range * Math.cos(direction),
                            mapFromLaser.y() + range * Math.sin(direction),
                            range);
            if (!isStrange) {
                if (points > 0) {
                    end(odomFromLaser, step);
                }
                continue;
            }
            double angle = odomFromLaser.theta() + scan.angle(beam);
            double px = odomFromLaser.x() + range * Math.cos(angle);
            double py = odomFromLaser.y() + range * Math.sin(angle);
            if (points > 0 && Math.hypot(px - endX, py - endY) > GAP + 2 * range * scan.angleIncrement()) {
                end(odomFromLaser, step);
            }
            if (points == 0) {
                startX = px;
                startY = py;
            }
            endX = px;
            endY = py;
            points++;
        }
        if (points > 0) {
            end(odomFromLaser, step);
        }
    }

    /// The beams of one body are read.
    private void end(Pose2d odomFromLaser, double step) {
        double half = Math.hypot(endX - startX, endY - startY) / 2;
        boolean isBody = points >= LEAST_POINTS && 2 * half <= LARGEST;
        points = 0;
        if (!isBody) {
            return;
        }
        double middleX = (startX + endX) / 2;
        double middleY = (startY + endY) / 2;
        double range = Math.max(0.1, Math.hypot(middleX - odomFromLaser.x(), middleY - odomFromLaser.y()));
        double depth = half / 2 / range; // what is seen is its front
        middleX += depth * (middleX - odomFromLaser.x());
        middleY += depth * (middleY - odomFromLaser.y());
        int nearest = -1;
        double least = GATE;
        for (int i = 0; i < tracks; i++) {
            double distance = Math.hypot(middleX - x[i], middleY - y[i]);
            if (!seen[i] && distance < least) {
                least = distance;
                nearest = i;
            }
        }
        if (nearest >= 0) {
            correct(nearest, middleX, middleY, half, step);
        } else if (tracks < MOST) {
            begin(tracks++, middleX, middleY, half);
        }
    }

    private void begin(int track, double atX, double atY, double half) {
        x[track] = atX;
        y[track] = atY;
        firstX[track] = atX;
        firstY[track] = atY;
        vx[track] = 0;
        vy[track] = 0;
        radius[track] = Math.max(LEAST_RADIUS, half);
        missed[track] = 0;
        hits[track] = 1;
        seen[track] = true;
    }

    private void correct(int track, double atX, double atY, double half, double step) {
        int k = ++hits[track];
        double alpha = Math.max(ALPHA, 2.0 * (2 * k - 1) / (k * (k + 1)));
        double beta = Math.max(BETA, 6.0 / (k * (k + 1)));
        double offX = atX - x[track];
        double offY = atY - y[track];
        x[track] += Math.min(1, alpha) * offX;
        y[track] += Math.min(1, alpha) * offY;
        vx[track] += Math.min(1, beta) * offX / step;
        vy[track] += Math.min(1, beta) * offY / step;
        radius[track] = Math.max(LEAST_RADIUS, Math.max(half, 0.95 * radius[track]));
        missed[track] = 0;
        seen[track] = true;
    }

    private void forget() {
        int kept = 0;
        for (int i = 0; i < tracks; i++) {
            if (missed[i] <= MEMORY) {
                x[kept] = x[i];
                y[kept] = y[i];
                vx[kept] = vx[i];
                vy[kept] = vy[i];
                firstX[kept] = firstX[i];
                firstY[kept] = firstY[i];
                radius[kept] = radius[i];
                missed[kept] = missed[i];
                hits[kept] = hits[i];
                kept++;
            }
        }
        tracks = kept;
    }

    private void list() {
        count = 0;
        double cos = Math.cos(baseFromOdom.theta());
        double sin = Math.sin(baseFromOdom.theta());
        for (int i = 0; i < tracks; i++) {
            if (hits[i] >= SEEN
                    && Math.hypot(vx[i], vy[i]) > SLOWEST
                    && Math.hypot(x[i] - firstX[i], y[i] - firstY[i]) > MOVED) {
                moving[count] = i;
                baseX[count] = baseFromOdom.x() + cos * x[i] - sin * y[i];
                baseY[count] = baseFromOdom.y() + sin * x[i] + cos * y[i];
                baseVx[count] = cos * vx[i] - sin * vy[i];
                baseVy[count] = sin * vx[i] + cos * vy[i];
                count++;
            }
        }
    }

    /// How many move.
    public int count() {
        return count;
    }

    /// Where one is, in the base frame [m].
    public double x(int i) {
        return baseX[i];
    }

    /// Where one is, in the base frame [m].
    public double y(int i) {
        return baseY[i];
    }

    /// Its velocity over ground along the base's axis [m/s].
    public double vx(int i) {
        return baseVx[i];
    }

    /// Its velocity over ground to the base's left [m/s].
    public double vy(int i) {
        return baseVy[i];
    }

    /// Of a circle about what is seen of it [m].
    public double radius(int i) {
        return radius[moving[i]];
    }

    /// Its speed over ground [m/s].
    public double speed(int i) {
        return Math.hypot(baseVx[i], baseVy[i]);
    }

    /// Whether one comes nearer.
    public boolean isComing(int i) {
        return baseX[i] * baseVx[i] + baseY[i] * baseVy[i] < 0;
    }

    /// Whether one comes towards the robot from ahead.
    ///
    /// @param within distance of the two [m]
    public boolean isAnyComing(double within) {
        for (int i = 0; i < count; i++) {
            double distance = Math.hypot(baseX[i], baseY[i]);
            double towards = baseX[i] * baseVx[i] + baseY[i] * baseVy[i];
            if (towards < -SLOWEST / 2 * distance && distance < within && baseX[i] > distance / 2) {
                return true;
            }
        }
        return false;
    }

    /// Adds where those that come nearer will be soon, so that controllers keep clear of these places, too.
    ///
    /// @param beyond no place nearer to the base [m]
    /// @param room to keep [m]
    public void predict(Obstacles obstacles, double beyond, double room) {
        for (int i = 0; i < count; i++) {
            for (int step = 1; step <= PREDICTED && isComing(i); step++) {
                double px = baseX[i] + step * PREDICTED_STEP * baseVx[i];
                double py = baseY[i] + step * PREDICTED_STEP * baseVy[i];
                int before = obstacles.count();
                if (Math.hypot(px, py) > beyond) {
                    obstacles.add(px, py);
                }
                if (obstacles.count() > before) {
                    obstacles.keepRoom(before, room);
                }
            }
        }
    }
}
