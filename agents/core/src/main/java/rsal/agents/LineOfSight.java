package rsal.agents;

import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.LaserScanner;
import rsal.robot.Robot;

/// Whether a robot's laser scanner sees that something stands between it and another robot.
final class LineOfSight {
    /// How much nearer than the other robot's middle all that is seen must be [m]: the other's radius, and by
    /// how much both may be wrong about where they are.
    private static final double NEARER = 0.4;
    /// How far to both sides of the other's middle it looks [m]: where that may really be.
    private static final double WIDTH = 0.15;

    private LineOfSight() {}

    /// Something is in the way in each direction in which the other robot could be seen. False where the robot
    /// has no laser scanner, or this does not look there: then nobody knows.
    static boolean isBlocked(Robot robot, Pose2d mapFromBase, Pose2d mapFromOther) {
        return robot.find(LaserScanner.class)
                .flatMap(LaserScanner::latest)
                .map(Stamped::value)
                .filter(scan -> isBlocked(scan, mapFromBase, mapFromOther))
                .isPresent();
    }

    /// The same with a reading of it.
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
