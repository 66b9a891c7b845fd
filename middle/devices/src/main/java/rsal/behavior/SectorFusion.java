package rsal.behavior;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;

/// Makes one picture of what laser and sonars see, with the smaller range counting: glass defeats lasers, soft
/// things defeat sonars. A sonar counts for the inner half of its cone, but only where it sees something that the
/// laser does not see in that cone at all; else it would blur each gap that the laser sees sharply.
///
/// Where the laser doesn't look now, what it saw there in the last minute counts, moved by odometry: a robot that
/// turns must know what is beside its tail, also when it stood for a while. A sonar that looks there and hears nothing
/// so near has it forgotten; one that hears something does not know how near that is, or where in its cone. What sonars
/// hear is too wide to be remembered. Belongs to one robot.
public final class SectorFusion {
    private static final Duration REMEMBERED = Duration.ofSeconds(60);

    /// What the two may differ by when they see the same thing.
    private static final double SAME = 0.1;

    private static final double SAME_SHARE = 0.05;

    /// How much of a sonar's cone a reading stands for. With all of it no door looks wide enough: of twelve walks
    /// of ten minutes in the office with eight sonars and no laser, the shortest was 61 m, with half of it 131 m,
    /// and nothing was touched in either.
    private static final double CONE = 0.5;

    private final double limit;
    private Memory memory = new Memory();
    private Memory spare = new Memory();
    private @Nullable Fan fan;

    /// What the laser saw, by the sector that it is in now: where in the odometry frame [m], and when. Sectors are
    /// too coarse to be moved along by each small turn.
    private static final class Memory {
        private final double[] x = new double[Surroundings.SECTORS];
        private final double[] y = new double[Surroundings.SECTORS];
        private final @Nullable Instant[] seen = new Instant[Surroundings.SECTORS];

        void put(int sector, double odomX, double odomY, Instant time) {
            x[sector] = odomX;
            y[sector] = odomY;
            seen[sector] = time;
        }
    }

    /// The directions that a laser's beams stand for, in the base frame: the same for all its scans.
    private static final class Fan {
        private final Pose2d baseFromLaser;
        private final double angleMin;
        private final double angleIncrement;
        private final int count;
        private final int copies; // a coarse scanner's beams stand for all between them
        private final double[] cos;
        private final double[] sin;

        Fan(LaserScan scan) {
            baseFromLaser = scan.baseFromLaser();
            angleMin = scan.angleMin();
            angleIncrement = scan.angleIncrement();
            count = scan.count();
            copies = Math.max(1, (int) Math.ceil(Math.abs(angleIncrement) / Surroundings.WIDTH));
            cos = new double[count * copies];
            sin = new double[count * copies];
            for (int i = 0; i < cos.length; i++) {
                double beside = ((i % copies + 0.5) / copies - 0.5) * angleIncrement;
                double direction = baseFromLaser.theta() + scan.angle(i / copies) + beside;
                cos[i] = Math.cos(direction);
                sin[i] = Math.sin(direction);
            }
        }

        boolean isOf(LaserScan scan) {
            return count == scan.count()
                    && angleMin == scan.angleMin()
                    && angleIncrement == scan.angleIncrement()
                    && baseFromLaser.equals(scan.baseFromLaser());
        }
    }

    /// @param limit things farther away than this do not count [m]
    public SectorFusion(double limit) {
        this.limit = limit;
    }

    /// @param now of this picture, not before that of the last
    public Surroundings fuse(Instant now, Pose2d odomFromBase, Optional<LaserScan> laser, Optional<RangeArray> sonars) {
        float[] ranges = nothing();
        laser.ifPresent(scan -> look(scan, ranges));
        float[] seen = ranges.clone();
        sonars.ifPresent(round -> {
            if (laser.isPresent()) {
                listen(round, seen, ranges);
            } else {
                listen(round, ranges);
            }
        });
        recall(now, odomFromBase, seen, ranges);
        remember(now, odomFromBase, seen);
        return new Surroundings(ranges);
    }

    /// Adds what is remembered of sectors that the laser doesn't look into, unless a sonar hears nothing so near. The
    /// rest is forgotten.
    private void recall(Instant now, Pose2d odomFromBase, float[] seen, float[] ranges) {
        float[] sensed = ranges.clone();
        double cos = Math.cos(odomFromBase.theta());
        double sin = Math.sin(odomFromBase.theta());
        Memory before = memory;
        memory = spare;
        spare = before;
        Arrays.fill(memory.seen, null);
        float[] nearest = nothing(); // of what is remembered
        for (int i = 0; i < Surroundings.SECTORS; i++) {
            Instant then = before.seen[i];
            if (then == null || then.plus(REMEMBERED).isBefore(now)) {
                continue;
            }
            double dx = before.x[i] - odomFromBase.x();
            double dy = before.y[i] - odomFromBase.y();
            double x = cos * dx + sin * dy;
            double y = cos * dy - sin * dx;
            int sector = Surroundings.sector(Math.atan2(y, x));
            float range = (float) Math.hypot(x, y);
            boolean isStillThere = Float.isNaN(seen[sector]) && !(sensed[sector] > range + SAME);
            if (isStillThere && !(nearest[sector] <= range)) {
                nearest[sector] = range;
                memory.put(sector, before.x[i], before.y[i], then);
                ranges[sector] = ranges[sector] <= range ? ranges[sector] : range; // also where nothing was
            }
        }
    }

    private void remember(Instant now, Pose2d odomFromBase, float[] seen) {
        double cos = Math.cos(odomFromBase.theta());
        double sin = Math.sin(odomFromBase.theta());
        for (int sector = 0; sector < seen.length; sector++) {
            if (seen[sector] < Float.POSITIVE_INFINITY) {
                double x = seen[sector] * Surroundings.cos(sector);
                double y = seen[sector] * Surroundings.sin(sector);
                memory.put(sector, odomFromBase.x() + cos * x - sin * y, odomFromBase.y() + sin * x + cos * y, now);
            }
        }
    }

    private static float[] nothing() {
        var ranges = new float[Surroundings.SECTORS];
        Arrays.fill(ranges, Float.NaN);
        return ranges;
    }

    private void look(LaserScan scan, float[] ranges) {
        Fan beams = fan;
        if (beams == null || !beams.isOf(scan)) {
            beams = new Fan(scan);
            fan = beams;
        }
        Pose2d mount = scan.baseFromLaser();
        for (int i = 0; i < beams.cos.length; i++) {
            double range = measured(scan.ranges()[i / beams.copies], scan.rangeMin(), scan.rangeMax());
            note(mount, beams.cos[i], beams.sin[i], range, ranges);
        }
    }

    /// Without a laser, all counts that sonars hear.
    private void listen(RangeArray round, float[] ranges) {
        double cone = CONE * round.fieldOfView();
        int steps = steps(cone);
        for (int i = 0; i < round.count(); i++) {
            double range = measured(round.ranges()[i], round.rangeMin(), round.rangeMax());
            Pose2d baseFromSonar = round.baseFromSensors().get(i);
            for (int step = 0; step <= steps; step++) {
                double direction = baseFromSonar.theta() + cone * ((double) step / steps - 0.5);
                note(baseFromSonar, Math.cos(direction), Math.sin(direction), range, ranges);
            }
        }
    }

    /// In how many parts a cone is looked at, so that no sector in it is missed.
    private static int steps(double cone) {
        return Math.max(1, (int) Math.ceil(cone / Surroundings.WIDTH * 2));
    }

    private void listen(RangeArray round, float[] seen, float[] ranges) {
        double cone = CONE * round.fieldOfView();
        int steps = steps(cone);
        for (int i = 0; i < round.count(); i++) {
            double range = measured(round.ranges()[i], round.rangeMin(), round.rangeMax());
            Pose2d baseFromSonar = round.baseFromSensors().get(i);
            double sight = nearestSeen(baseFromSonar, cone, steps, range, seen);
            boolean explained = sight <= range + SAME + SAME_SHARE * range;
            for (int step = 0; step <= steps; step++) {
                double angle = cone * ((double) step / steps - 0.5);
                boolean unseen = Float.isNaN(seen[sector(baseFromSonar, angle, range)]);
                if (unseen || !explained) {
                    double direction = baseFromSonar.theta() + angle;
                    note(baseFromSonar, Math.cos(direction), Math.sin(direction), range, ranges);
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
                double x = seen[sector] * Surroundings.cos(sector) - baseFromSonar.x();
                double y = seen[sector] * Surroundings.sin(sector) - baseFromSonar.y();
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

    /// @param cos of the direction in the base frame
    private void note(Pose2d baseFromSensor, double cos, double sin, double range, float[] ranges) {
        if (Double.isNaN(range)) {
            return;
        }
        double reach = Math.min(range, limit);
        double x = baseFromSensor.x() + reach * cos;
        double y = baseFromSensor.y() + reach * sin;
        int sector = Surroundings.sector(Math.atan2(y, x));
        float noted = range < Double.POSITIVE_INFINITY ? (float) Math.sqrt(x * x + y * y) : Float.POSITIVE_INFINITY;
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
