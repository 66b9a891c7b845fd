package rsal.navigation.device;

import java.util.List;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// A robot of the same team: no part of the building, wherever it stands.
///
/// @param mapFromMate where it says that it is
/// @param radius of the circle that it turns in [m]
record Mate(Point2d mapFromMate, double radius) {
    private static final double UNSURE = 0.15; // m by which two robots may mistake where they are

    /// A scan without beams that end at mates: these are broken (NaN).
    static LaserScan leaveOut(List<Mate> mates, LaserScan scan, Pose2d mapFromBase) {
        Pose2d mapFromLaser = mapFromBase.compose(scan.baseFromLaser());
        List<Mate> near = mates.stream()
                .filter(mate -> mate.mapFromMate.distanceTo(mapFromLaser.position()) < scan.rangeMax() + mate.radius)
                .toList();
        if (near.isEmpty()) {
            return scan;
        }
        float[] ranges = scan.ranges().clone();
        for (int beam = 0; beam < ranges.length; beam++) {
            if (scan.isHit(beam)) {
                double direction = mapFromLaser.theta() + scan.angle(beam);
                double x = mapFromLaser.x() + ranges[beam] * Math.cos(direction);
                double y = mapFromLaser.y() + ranges[beam] * Math.sin(direction);
                for (Mate mate : near) {
                    double reach = mate.radius + UNSURE;
                    double dx = x - mate.mapFromMate.x();
                    double dy = y - mate.mapFromMate.y();
                    if (dx * dx + dy * dy <= reach * reach) {
                        ranges[beam] = Float.NaN;
                    }
                }
            }
        }
        return new LaserScan(
                scan.baseFromLaser(), scan.angleMin(), scan.angleIncrement(), scan.rangeMin(), scan.rangeMax(), ranges);
    }
}
