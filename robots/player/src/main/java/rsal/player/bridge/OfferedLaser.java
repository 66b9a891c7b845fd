package rsal.player.bridge;

import java.util.List;
import java.util.Optional;
import rsal.data.LaserScan;
import rsal.data.Stamped;
import rsal.device.LaserScanner;
import rsal.device.Subscription;
import rsal.player.message.Interface;
import rsal.player.message.Laser;
import rsal.player.message.Ranger;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A laser scanner as `laser`, or as `ranger`.
final class OfferedLaser extends Offered {
    private final LaserScanner scanner;
    private int scans;

    /// @param as `laser` or `ranger`
    OfferedLaser(Interface as, int index, LaserScanner scanner, Scheduler scheduler) {
        super(as, index, scanner.info(), scheduler);
        this.scanner = scanner;
    }

    @Override
    Subscription listen() {
        return scanner.subscribe(this::tell);
    }

    private void tell(Stamped<LaserScan> reading) {
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
    public boolean understands(Kind kind, int subtype) {
        return kind == Kind.REQUEST
                && (interf() == Interface.RANGER
                        ? subtype == Ranger.GEOMETRY || subtype == Ranger.CONFIGURATION
                        : subtype == Laser.GEOMETRY || subtype == Laser.CONFIGURATION);
    }

    /// Nothing, before it has measured once.
    @Override
    Optional<Answer> answer(Packet request) {
        int subtype = request.header().subtype();
        return scanner.latest()
                .map(Stamped::value)
                .filter(_ -> understands(Kind.REQUEST, subtype))
                .map(scan ->
                        new Answer.Told(interf() == Interface.RANGER ? ranger(scan, subtype) : laser(scan, subtype)));
    }

    private static Record ranger(LaserScan scan, int subtype) {
        if (subtype == Ranger.GEOMETRY) {
            return new Ranger.Geometry(
                    pose3(scan.baseFromLaser()), NO_SIZE, List.of(pose3(scan.baseFromLaser())), List.of(NO_SIZE));
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
            return new Laser.Geometry(pose3(scan.baseFromLaser()), NO_SIZE);
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
