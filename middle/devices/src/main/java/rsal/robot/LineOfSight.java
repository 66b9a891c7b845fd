package rsal.robot;

import java.util.Optional;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Walls;
import rsal.device.LaserScanner;
import rsal.device.Localizer;

/// Whether something stands between a robot and another one, as far as it knows: a wall of the map that it was
/// given, or, without a map, what its laser scanner sees. Who is seen in part is not hidden.
public final class LineOfSight {
    /// How much nearer than the other robot's middle all that a scanner sees must be [m]: the other's radius,
    /// and by how much both may be wrong about where they are.
    private static final double NEARER = 0.4;
    /// How far to both sides of the other's middle it looks [m].
    private static final double WIDTH = 0.15;

    private LineOfSight() {}

    /// False where nobody knows: the robot has neither map nor scanner, or this does not look there.
    ///
    /// @param mapFromBase where the robot believes to be
    public static boolean isBlocked(Robot robot, Pose2d mapFromBase, Pose2d mapFromOther) {
        Optional<OccupancyGrid> map = robot.find(Localizer.class).flatMap(Localizer::givenMap);
        if (map.isPresent()) {
            return new Walls(map.get()).hide(mapFromBase.position(), mapFromOther.position(), WIDTH);
        }
        return robot.find(LaserScanner.class)
                .flatMap(LaserScanner::latest)
                .map(Stamped::value)
                .filter(scan -> isBlocked(scan, mapFromBase, mapFromOther))
                .isPresent();
    }

    /// Whether another robot is nearer than that, with nothing between.
    ///
    /// @param mapFromBase where the robot believes to be
    /// @param range [m]
    public static boolean reaches(Robot robot, Pose2d mapFromBase, Pose2d mapFromOther, double range) {
        return mapFromBase.distanceTo(mapFromOther) < range && !isBlocked(robot, mapFromBase, mapFromOther);
    }

    /// [#isBlocked] by a reading of its scanner.
    static boolean isBlocked(LaserScan scan, Pose2d mapFromBase, Pose2d mapFromOther) {
        Pose2d mapFromLaser = mapFromBase.compose(scan.baseFromLaser());
        double distance = mapFromLaser.distanceTo(mapFromOther);
        if (distance <= NEARER) {
            return false;
        }
        double direction = mapFromLaser.bearingTo(mapFromOther.position());
        double half = Math.atan2(WIDTH, distance);
        int first = (int) Math.floor((direction - half - scan.angleMin()) / scan.angleIncrement());
        int last = (int) Math.ceil((direction + half - scan.angleMin()) / scan.angleIncrement());
        if (first < 0 || last >= scan.count()) {
            return false;
        }
        for (int beam = first; beam <= last; beam++) {
            if (!(scan.distance(beam) < distance - NEARER)) {
                return false;
            }
        }
        return true;
    }
}
