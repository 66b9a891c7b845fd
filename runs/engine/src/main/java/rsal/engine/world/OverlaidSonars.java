package rsal.engine.world;

import java.util.List;
import rsal.data.Fan;
import rsal.data.RangeArray;
import rsal.device.SonarArray;

/// A real robot's sonars that see what is simulated, too: in each cone what is nearest.
final class OverlaidSonars extends OverlaidSensor<RangeArray> implements SonarArray {
    OverlaidSonars(SonarArray sonars, Overlay overlay) {
        super(sonars, overlay);
    }

    @Override
    List<Fan> fans(RangeArray round) {
        return round.baseFromSensors().stream()
                .map(baseFromSensor -> Fan.cone(baseFromSensor, round.fieldOfView()))
                .toList();
    }

    @Override
    double reach(RangeArray round) {
        return round.rangeMax();
    }

    @Override
    RangeArray nearest(RangeArray round, List<Fan> cones, double[] simulated) {
        float[] ranges = round.ranges().clone();
        int ray = 0;
        for (int sensor = 0; sensor < ranges.length; sensor++) {
            for (int end = ray + cones.get(sensor).count(); ray < end; ray++) {
                ranges[sensor] = Overlay.nearer(ranges[sensor], simulated[ray], round.rangeMin(), round.rangeMax());
            }
        }
        return new RangeArray(round.baseFromSensors(), round.fieldOfView(), round.rangeMin(), round.rangeMax(), ranges);
    }
}
