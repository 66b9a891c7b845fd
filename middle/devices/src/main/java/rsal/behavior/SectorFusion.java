package rsal.behavior;

import java.util.Arrays;
import java.util.Optional;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;

/// Makes one picture of what laser and sonars see, with the smaller range counting: glass defeats lasers, soft
/// things defeat sonars. A sonar counts for all of its cone, but only where it sees something that the laser does
/// not see in that cone at all; else it would blur each gap that the laser sees sharply.
public final class SectorFusion {
    /// What the two may differ by when they see the same thing.
    private static final double SAME = 0.1;

    private static final double SAME_SHARE = 0.05;

    private final double limit;

    /// @param limit things farther away than this do not count [m]
    public SectorFusion(double limit) {
        this.limit = limit;
    }

    public Surroundings fuse(Optional<LaserScan> laser, Optional<RangeArray> sonars) {
        var ranges = new float[Surroundings.SECTORS];
        Arrays.fill(ranges, Float.NaN);
        laser.ifPresent(scan -> look(scan, ranges));
        sonars.ifPresent(round -> listen(round, ranges));
        return new Surroundings(ranges);
    }

    private void look(LaserScan scan, float[] ranges) {
        int copies = Math.max(1, (int) Math.ceil(Math.abs(scan.angleIncrement()) / Surroundings.WIDTH));
        for (int beam = 0; beam < scan.count(); beam++) {
            double range = measured(scan.ranges()[beam], scan.rangeMin(), scan.rangeMax());
            for (int copy = 0; copy < copies; copy++) { // a coarse scanner's beams stand for all between them
                double angle = scan.angle(beam) + ((copy + 0.5) / copies - 0.5) * scan.angleIncrement();
                note(scan.baseFromLaser(), angle, range, ranges);
            }
        }
    }

    private void listen(RangeArray round, float[] ranges) {
        float[] seen = ranges.clone();
        int steps = Math.max(1, (int) Math.ceil(round.fieldOfView() / Surroundings.WIDTH * 2));
        for (int i = 0; i < round.count(); i++) {
            double range = measured(round.ranges()[i], round.rangeMin(), round.rangeMax());
            Pose2d baseFromSonar = round.baseFromSensors().get(i);
            double sight = nearestSeen(baseFromSonar, round.fieldOfView(), steps, range, seen);
            boolean explained = sight <= range + SAME + SAME_SHARE * range;
            for (int step = 0; step <= steps; step++) {
                double angle = round.fieldOfView() * ((double) step / steps - 0.5);
                boolean unseen = Float.isNaN(seen[sector(baseFromSonar, angle, range)]);
                if (unseen || !explained) {
                    note(baseFromSonar, angle, range, ranges);
                }
            }
        }
    }

    /// The shortest range that the laser sees within a sonar's cone, from the sonar [m].
    private double nearestSeen(Pose2d baseFromSonar, double fieldOfView, int steps, double range, float[] seen) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int step = 0; step <= steps; step++) {
            int sector = sector(baseFromSonar, fieldOfView * ((double) step / steps - 0.5), range);
            if (seen[sector] < Float.POSITIVE_INFINITY) {
                double x = seen[sector] * Math.cos(Surroundings.direction(sector)) - baseFromSonar.x();
                double y = seen[sector] * Math.sin(Surroundings.direction(sector)) - baseFromSonar.y();
                nearest = Math.min(nearest, Math.hypot(x, y));
            }
        }
        return nearest;
    }

    /// A reading after REP 117 as a distance: what is too close is at the sensor's least range, what is beyond the
    /// limit is nothing, what is broken stays NaN.
    private double measured(double range, double min, double max) {
        if (range < min) {
            return min;
        }
        return range > Math.min(max, limit) ? Double.POSITIVE_INFINITY : range;
    }

    private void note(Pose2d baseFromSensor, double angle, double range, float[] ranges) {
        if (Double.isNaN(range)) {
            return;
        }
        double reach = Math.min(range, limit);
        double x = baseFromSensor.x() + reach * Math.cos(baseFromSensor.theta() + angle);
        double y = baseFromSensor.y() + reach * Math.sin(baseFromSensor.theta() + angle);
        int sector = Surroundings.sector(Math.atan2(y, x));
        float noted = range < Double.POSITIVE_INFINITY ? (float) Math.hypot(x, y) : Float.POSITIVE_INFINITY;
        if (!(ranges[sector] <= noted)) { // also when nothing was noted yet
            ranges[sector] = noted;
        }
    }

    private int sector(Pose2d baseFromSensor, double angle, double range) {
        double reach = Double.isNaN(range) ? limit : Math.min(range, limit);
        double x = baseFromSensor.x() + reach * Math.cos(baseFromSensor.theta() + angle);
        double y = baseFromSensor.y() + reach * Math.sin(baseFromSensor.theta() + angle);
        return Surroundings.sector(Math.atan2(y, x));
    }
}
