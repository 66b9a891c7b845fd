package rsal.behavior;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.RangeArray;

/// Makes one picture of what laser and sonars see, with the smaller range counting: glass defeats lasers, soft
/// things defeat sonars. A sonar counts for the inner half of its cone, but only where it sees something that the
/// laser does not see in that cone at all; else it would blur each gap that the laser sees sharply.
///
/// Where no sensor looks now, what the laser saw there in the last seconds counts, moved by odometry: a robot
/// that turns must know what is beside its tail. What sonars hear is too wide to be remembered. Belongs to one
/// robot.
public final class SectorFusion {
    private static final Duration REMEMBERED = Duration.ofSeconds(10);

    /// What the two may differ by when they see the same thing.
    private static final double SAME = 0.1;

    private static final double SAME_SHARE = 0.05;

    /// How much of a sonar's cone a reading stands for. With all of it no door looks wide enough: of twelve walks
    /// of ten minutes in the office with eight sonars and no laser, the shortest was 61 m, with half of it 131 m,
    /// and nothing was touched in either.
    private static final double CONE = 0.5;

    private final double limit;
    private final @Nullable Instant[] seenAt = new Instant[Surroundings.SECTORS];
    private Surroundings last = new Surroundings(nothing());
    private Pose2d odomFromLast = Pose2d.ORIGIN;

    /// @param limit things farther away than this do not count [m]
    public SectorFusion(double limit) {
        this.limit = limit;
    }

    /// @param now of this picture, not before that of the last
    public Surroundings fuse(Instant now, Pose2d odomFromBase, Optional<LaserScan> laser, Optional<RangeArray> sonars) {
        float[] ranges = nothing();
        laser.ifPresent(scan -> look(scan, ranges));
        float[] sharp = ranges.clone();
        sonars.ifPresent(round -> listen(round, sharp, ranges));
        remember(now, odomFromBase, sharp, ranges);
        last = new Surroundings(ranges);
        odomFromLast = odomFromBase;
        return last;
    }

    private void remember(Instant now, Pose2d odomFromBase, float[] sharp, float[] ranges) {
        Pose2d baseFromLast = odomFromBase.inverse().compose(odomFromLast);
        float[] seen = ranges.clone();
        @Nullable Instant[] before = seenAt.clone();
        for (int sector = 0; sector < sharp.length; sector++) {
            seenAt[sector] = Float.isNaN(sharp[sector]) ? null : now;
        }
        for (int from = 0; from < ranges.length; from++) {
            float range = last.range(from);
            Instant then = before[from];
            if (!(range < Float.POSITIVE_INFINITY)
                    || then == null
                    || then.plus(REMEMBERED).isBefore(now)) {
                continue;
            }
            Point2d thing = baseFromLast.transform(last.thing(from));
            int sector = Surroundings.sector(Math.atan2(thing.y(), thing.x()));
            float noted = (float) Math.hypot(thing.x(), thing.y());
            if (Float.isNaN(seen[sector]) && !(ranges[sector] <= noted)) {
                ranges[sector] = noted;
                seenAt[sector] = then;
            }
        }
    }

    private static float[] nothing() {
        var ranges = new float[Surroundings.SECTORS];
        Arrays.fill(ranges, Float.NaN);
        return ranges;
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

    private void listen(RangeArray round, float[] seen, float[] ranges) {
        double cone = CONE * round.fieldOfView();
        int steps = Math.max(1, (int) Math.ceil(cone / Surroundings.WIDTH * 2));
        for (int i = 0; i < round.count(); i++) {
            double range = measured(round.ranges()[i], round.rangeMin(), round.rangeMax());
            Pose2d baseFromSonar = round.baseFromSensors().get(i);
            double sight = nearestSeen(baseFromSonar, cone, steps, range, seen);
            boolean explained = sight <= range + SAME + SAME_SHARE * range;
            for (int step = 0; step <= steps; step++) {
                double angle = cone * ((double) step / steps - 0.5);
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

    /// A reading after REP 117 as a distance: what is too close is at the sensor's least range, what is beyond
    /// the limit is nothing, what is broken stays NaN.
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
