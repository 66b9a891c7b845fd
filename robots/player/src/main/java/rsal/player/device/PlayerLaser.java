package rsal.player.device;

import java.util.List;
import java.util.Optional;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.device.LaserScanner;
import rsal.player.message.Laser;
import rsal.player.message.Ranger;
import rsal.player.wire.Address;
import rsal.robot.RobotModel.Part;

/// A laser scanner behind `ranger` or `laser`. Where it is mounted, which way it looks and how far is what the server
/// says; of what that does not say, what the robot's model says.
final class PlayerLaser extends PlayerSensor<LaserScan> implements LaserScanner {
    private Pose2d baseFromLaser;
    private double angleMin;
    private double angleMax;
    private double rangeMin;
    private double rangeMax;

    PlayerLaser(DeviceInfo info, Address address, Part.Laser part) {
        super(info, address, info.id());
        this.baseFromLaser = part.baseFromLaser();
        this.angleMin = part.angleMin();
        this.angleMax = part.angleMin() + (part.samples() - 1) * part.angleIncrement();
        this.rangeMin = part.rangeMin();
        this.rangeMax = part.rangeMax();
    }

    @Override
    public List<Integer> questions() {
        return Ranges.questions(address(), Laser.GEOMETRY);
    }

    @Override
    public void answered(Record body) {
        switch (body) {
            case Ranger.Geometry geometry ->
                baseFromLaser = geometry.poses().size() == 1
                        ? Ranges.places(geometry).getFirst()
                        : geometry.pose().to2d();
            case Laser.Geometry geometry -> baseFromLaser = geometry.pose().to2d();
            case Ranger.Configuration configuration -> {
                if (Ranges.isKnown(configuration)) {
                    angleMin = configuration.minAngle();
                    angleMax = configuration.maxAngle();
                    rangeMin = configuration.minRange();
                    rangeMax = configuration.maxRange();
                }
            }
            default -> {}
        }
    }

    /// Scans without a beam are none.
    @Override
    Optional<LaserScan> read(Record body) {
        Optional<LaserScan> scan = switch (body) {
            case Ranger.Ranges(double[] ranges) -> Optional.of(scan(Ranges.of(ranges, rangeMin, rangeMax)));
            case Ranger.RangesStamped stamped ->
                Optional.of(scan(Ranges.of(stamped.ranges().ranges(), rangeMin, rangeMax)));
            case Laser.Scan laser -> laser(laser);
            case Laser.ScanPose with -> laser(with.scan());
            default -> Optional.empty();
        };
        return scan.filter(reported -> reported.count() > 0);
    }

    /// Beams lie as far apart as the angle between the first and the last has it: what Stage says of the angle between
    /// two is not so.
    private LaserScan scan(float[] ranges) {
        double increment = ranges.length > 1 ? (angleMax - angleMin) / (ranges.length - 1) : 0;
        return new LaserScan(baseFromLaser, angleMin, increment, rangeMin, rangeMax, ranges);
    }

    /// Before it knows better, Player's `rangertolaser` tells scans whose angles and ranges are all 0.
    private Optional<LaserScan> laser(Laser.Scan scan) {
        double width = (double) scan.resolution() * scan.ranges().length;
        if (!(scan.resolution() > 0 && width < Ranges.WIDEST && scan.maxRange() > 0)) {
            return Optional.empty();
        }
        return Optional.of(new LaserScan(
                baseFromLaser,
                scan.minAngle(),
                scan.resolution(),
                rangeMin,
                scan.maxRange(),
                Ranges.of(scan.ranges(), rangeMin, scan.maxRange())));
    }
}
