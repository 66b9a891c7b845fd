package rsal.engine.world;

import java.util.List;
import rsal.data.Fan;
import rsal.data.LaserScan;
import rsal.device.LaserScanner;

/// A real robot's laser scanner that sees what is simulated, too.
final class OverlaidLaser extends OverlaidSensor<LaserScan> implements LaserScanner {
    OverlaidLaser(LaserScanner laser, Overlay overlay) {
        super(laser, overlay);
    }

    @Override
    List<Fan> fans(LaserScan scan) {
        return scan.count() == 0
                ? List.of()
                : List.of(new Fan(scan.baseFromLaser(), scan.angleMin(), scan.angleIncrement(), scan.count()));
    }

    @Override
    double reach(LaserScan scan) {
        return scan.rangeMax();
    }

    @Override
    LaserScan nearest(LaserScan scan, List<Fan> fans, double[] simulated) {
        float[] ranges = scan.ranges().clone();
        for (int beam = 0; beam < ranges.length; beam++) {
            ranges[beam] = Overlay.nearer(ranges[beam], simulated[beam], scan.rangeMin(), scan.rangeMax());
        }
        return new LaserScan(
                scan.baseFromLaser(), scan.angleMin(), scan.angleIncrement(), scan.rangeMin(), scan.rangeMax(), ranges);
    }
}
