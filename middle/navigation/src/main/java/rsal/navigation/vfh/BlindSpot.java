package rsal.navigation.vfh;

import java.time.Duration;
import java.time.Instant;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Remembers what was near the robot before it came to where the laser doesn't look: the door post that the tail
/// would swing into. Walls are remembered until they are out of reach, what may move only for a while.
public final class BlindSpot {
    private static final int MOST = 1024;

    private final double reach;
    private final Duration fades;
    private final double[] x = new double[MOST]; // in the odometry frame, which drifts little within the reach
    private final double[] y = new double[MOST];
    private final boolean[] wall = new boolean[MOST];
    private final Instant[] seen = new Instant[MOST];
    private int count;

    /// @param reach how far from the base things are remembered [m]
    /// @param fades after what time things that may move are forgotten
    public BlindSpot(double reach, Duration fades) {
        this.reach = reach;
        this.fades = fades;
    }

    public void forget() {
        count = 0;
    }

    /// Adds what is remembered of the places that the scan doesn't look at.
    ///
    /// @param moverRoom to keep from what may move [m]
    public void recall(LaserScan scan, Pose2d odomFromBase, Instant now, double moverRoom, Obstacles obstacles) {
        Pose2d baseFromOdom = odomFromBase.inverse();
        Pose2d mount = scan.baseFromLaser();
        int kept = 0;
        for (int i = 0; i < count; i++) {
            Point2d place = baseFromOdom.transform(new Point2d(x[i], y[i]));
            double direction = Math.atan2(place.y() - mount.y(), place.x() - mount.x());
            boolean gone = Math.hypot(place.x(), place.y()) > reach
                    || (!wall[i] && seen[i].plus(fades).isBefore(now))
                    || Obstacles.covers(scan, direction);
            if (!gone) {
                x[kept] = x[i];
                y[kept] = y[i];
                wall[kept] = wall[i];
                seen[kept] = seen[i];
                kept++;
                obstacles.add(place.x(), place.y());
                if (!wall[i]) {
                    obstacles.keepRoom(obstacles.count() - 1, moverRoom);
                }
            }
        }
        count = kept;
    }

    /// Notes what is seen now near the robot: the first obstacles, without those that were only recalled. What
    /// keeps more room may move.
    public void note(Obstacles obstacles, int seenNow, Pose2d odomFromBase, Instant now) {
        for (int i = 0; i < seenNow && count < MOST; i++) {
            if (Math.hypot(obstacles.x(i), obstacles.y(i)) <= reach) {
                Point2d place = odomFromBase.transform(obstacles.at(i));
                x[count] = place.x();
                y[count] = place.y();
                wall[count] = obstacles.room(i) == 0;
                seen[count] = now;
                count++;
            }
        }
    }
}
