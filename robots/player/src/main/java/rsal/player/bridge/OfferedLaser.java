package rsal.player.bridge;

import java.util.List;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.LaserScanner;
import rsal.player.message.Box3;
import rsal.player.message.Interface;
import rsal.player.message.Laser;
import rsal.player.message.Pose3;
import rsal.player.message.Ranger;
import rsal.player.wire.MessageKind;
import rsal.time.Scheduler;

/// A laser scanner as `laser`, or as `ranger`.
final class OfferedLaser extends OfferedSensor<LaserScan> {
    private static final Box3 SIZE = new Box3(0.1, 0.1, 0.1); // about; no model tells, and without it clients draw none

    private int scans;

    /// @param as `laser` or `ranger`
    OfferedLaser(Interface as, int index, LaserScanner scanner, Scheduler scheduler) {
        super(as, index, scanner, scheduler);
    }

    @Override
    void publish(Stamped<LaserScan> reading) {
        LaserScan scan = reading.value();
        if (interf() == Interface.RANGER) {
            publish(Ranger.RANGES, reading.time(), new Ranger.Ranges(Measured.doubles(scan.ranges(), scan.rangeMax())));
            return;
        }
        var laser = new Laser.Scan(
                (float) scan.angleMin(),
                (float) scan.angle(scan.count() - 1),
                (float) scan.angleIncrement(),
                (float) scan.rangeMax(),
                Measured.floats(scan.ranges(), scan.rangeMax()),
                new byte[scan.count()],
                scans++);
        publish(Laser.SCAN, reading.time(), laser);
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST
                && (interf() == Interface.RANGER
                        ? subtype == Ranger.GEOMETRY || subtype == Ranger.CONFIGURATION
                        : subtype == Laser.GEOMETRY || subtype == Laser.CONFIGURATION);
    }

    @Override
    Record body(LaserScan newest, int subtype) {
        return interf() == Interface.RANGER ? ranger(newest, subtype) : laser(newest, subtype);
    }

    private static Record ranger(LaserScan scan, int subtype) {
        if (subtype == Ranger.GEOMETRY) {
            return new Ranger.Geometry(
                    Pose3.of(scan.baseFromLaser()), SIZE, List.of(Pose3.of(Pose2d.ORIGIN)), List.of(SIZE));
        }
        return new Ranger.Configuration(
                scan.angleMin(),
                scan.angle(scan.count() - 1),
                scan.angleIncrement(),
                scan.rangeMin(),
                scan.rangeMax(),
                0,
                0);
    }

    private static Record laser(LaserScan scan, int subtype) {
        if (subtype == Laser.GEOMETRY) {
            return new Laser.Geometry(Pose3.of(scan.baseFromLaser()), SIZE);
        }
        return new Laser.Configuration(
                (float) scan.angleMin(),
                (float) scan.angle(scan.count() - 1),
                (float) scan.angleIncrement(),
                (float) scan.rangeMax(),
                0,
                0,
                0);
    }
}
