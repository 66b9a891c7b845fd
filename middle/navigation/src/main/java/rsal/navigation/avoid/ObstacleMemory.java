package rsal.navigation.avoid;

import java.time.Duration;
import java.time.Instant;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Remembers what was near the robot before it came to where the laser doesn't look, or where its beams are broken:
/// the door post that the tail would swing into. Walls are remembered until they are out of reach, what may move only
/// for a while.
public final class ObstacleMemory {
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
    public ObstacleMemory(double reach, Duration fades) {
        this.reach = reach;
        this.fades = fades;
    }

    /// Adds what is remembered of the places that the scan doesn't look at.
    ///
    /// @param moverRoom to keep from what may move [m]
    public void recall(LaserScan scan, Pose2d odomFromBase, Instant now, double moverRoom, Obstacles obstacles) {
        Pose2d baseFromOdom = odomFromBase.inverse();
        int kept = 0;
        for (int i = 0; i < count; i++) {
            Point2d place = baseFromOdom.transform(new Point2d(x[i], y[i]));
            boolean gone = Math.hypot(place.x(), place.y()) > reach
                    || (!wall[i] && seen[i].plus(fades).isBefore(now))
                    || isLookedAt(scan, place);
            if (!gone) {
                x[kept] = x[i];
                y[kept] = y[i];
                wall[kept] = wall[i];
                seen[kept] = seen[i];
                kept++;
                int before = obstacles.count();
                obstacles.add(place.x(), place.y());
                if (!wall[i] && obstacles.count() > before) {
                    obstacles.keepRoom(obstacles.count() - 1, moverRoom);
                }
            }
        }
        count = kept;
    }

    /// Notes what is near the robot where the scan looks. What is known of other places (by recalling, or from
    /// sonars) is not noted: it would be noted again each time. What keeps more room may move.
    public void note(LaserScan scan, Obstacles obstacles, Pose2d odomFromBase, Instant now) {
        for (int i = 0; i < obstacles.count() && count < MOST; i++) {
            Point2d seenAt = obstacles.at(i);
            if (Math.hypot(seenAt.x(), seenAt.y()) <= reach && isLookedAt(scan, seenAt)) {
                Point2d place = odomFromBase.transform(seenAt);
                x[count] = place.x();
                y[count] = place.y();
                wall[count] = obstacles.room(i) == 0;
                seen[count] = now;
                count++;
            }
        }
    }

    private static boolean isLookedAt(LaserScan scan, Point2d place) {
        Pose2d mount = scan.baseFromLaser();
        return Obstacles.looks(scan, Math.atan2(place.y() - mount.y(), place.x() - mount.x()));
    }
}
