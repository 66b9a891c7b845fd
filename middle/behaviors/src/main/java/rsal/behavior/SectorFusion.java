package rsal.behavior;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Rep117;

/// Makes one picture of what laser and sonars see, with the smaller range counting: glass defeats lasers, soft
/// things defeat sonars. A sonar counts for the inner half of its cone, but only where it sees something that the
/// laser does not see in that cone at all; else it would blur each gap that the laser sees sharply.
///
/// Where the laser doesn't look now, what it saw there in the last minute counts, moved by odometry: a robot that
/// turns must know what is beside its tail, also when it stood for a while. A sonar that looks there and hears nothing
/// so near has it forgotten; one that hears something does not know how near that is, or where in its cone. What sonars
/// hear is too wide to be remembered. Belongs to one robot.
public final class SectorFusion {
    private static final long REMEMBERED = Duration.ofSeconds(60).toNanos();
    private static final long NEVER = Long.MIN_VALUE;

    /// What the two may differ by when they see the same thing.
    private static final double SAME = 0.1;

    private static final double SAME_SHARE = 0.05;

    /// How much of a sonar's cone a reading stands for. With all of it no door looks wide enough: of twelve walks
    /// of ten minutes in the office with eight sonars and no laser, the shortest was 61 m, with half of it 131 m,
    /// and nothing was touched in either.
    private static final double CONE = 0.5;

    private final double limit;
    private final float[] seen = new float[Surroundings.SECTORS]; // by the laser now
    private final float[] sensed = new float[Surroundings.SECTORS]; // by laser and sonars now
    private final float[] nearest = new float[Surroundings.SECTORS]; // of what is remembered
    private Memory memory = new Memory();
    private Memory spare = new Memory();
    private boolean remembers; // whether there is anything in the memory
    private @Nullable Fan fan;
    private @Nullable Cones cones;

    /// What the laser saw, by the sector that it is in now: where in the odometry frame [m], and when. Sectors are
    /// too coarse to be moved along by each small turn.
    private static final class Memory {
        private final double[] x = new double[Surroundings.SECTORS];
        private final double[] y = new double[Surroundings.SECTORS];
        private final long[] seen = new long[Surroundings.SECTORS]; // [ns] since the epoch; NEVER

        void clear() {
            Arrays.fill(seen, NEVER);
        }

        void put(int sector, double odomX, double odomY, long time) {
            x[sector] = odomX;
            y[sector] = odomY;
            seen[sector] = time;
        }
    }

    /// Directions in the base frame that sensors look along, each from where its sensor is mounted.
    private static final class Rays {
        private final double[] cos;
        private final double[] sin;
        private final int[] sectors; // that they ended in last, as most do again

        Rays(int count, IntToDoubleFunction direction) {
            cos = new double[count];
            sin = new double[count];
            sectors = new int[count];
            for (int i = 0; i < count; i++) {
                cos[i] = Math.cos(direction.applyAsDouble(i));
                sin[i] = Math.sin(direction.applyAsDouble(i));
            }
        }

        int count() {
            return cos.length;
        }

        /// The sector that one ends in after some way.
        int sector(int ray, Pose2d baseFromSensor, double reach) {
            sectors[ray] = Surroundings.sectorOf(
                    baseFromSensor.x() + reach * cos[ray], baseFromSensor.y() + reach * sin[ray], sectors[ray]);
            return sectors[ray];
        }

        /// @param range +∞ for nothing up to the limit; not NaN
        /// @param ranges the nearest of each sector
        void note(int ray, Pose2d baseFromSensor, double range, double limit, float[] ranges) {
            double reach = Math.min(range, limit);
            int sector = sector(ray, baseFromSensor, reach);
            float noted = Float.POSITIVE_INFINITY;
            if (range < noted) {
                double x = baseFromSensor.x() + reach * cos[ray];
                double y = baseFromSensor.y() + reach * sin[ray];
                noted = (float) Math.sqrt(x * x + y * y);
            }
            if (!(ranges[sector] <= noted)) { // also when nothing was noted yet
                ranges[sector] = noted;
            }
        }
    }

    /// The directions that a laser's beams stand for, in the base frame: the same for all its scans.
    private static final class Fan {
        private final Pose2d baseFromLaser;
        private final double angleMin;
        private final double angleIncrement;
        private final int count;
        private final int copies; // a coarse scanner's beams stand for all between them
        private final Rays rays;

        Fan(LaserScan scan) {
            baseFromLaser = scan.baseFromLaser();
            angleMin = scan.angleMin();
            angleIncrement = scan.angleIncrement();
            count = scan.count();
            copies = Math.max(1, (int) Math.ceil(Math.abs(angleIncrement) / Surroundings.WIDTH));
            rays = new Rays(count * copies, i -> {
                double beside = ((i % copies + 0.5) / copies - 0.5) * angleIncrement;
                return baseFromLaser.theta() + scan.angle(i / copies) + beside;
            });
        }

        boolean isOf(LaserScan scan) {
            return count == scan.count()
                    && angleMin == scan.angleMin()
                    && angleIncrement == scan.angleIncrement()
                    && baseFromLaser.equals(scan.baseFromLaser());
        }
    }

    /// The directions that sonars' cones are looked at along, in the base frame: the same for all rounds.
    private static final class Cones {
        private final List<Pose2d> baseFromSonars;
        private final double fieldOfView;
        private final int directions; // of each sonar
        private final Rays rays;

        Cones(RangeArray round) {
            baseFromSonars = round.baseFromSensors();
            fieldOfView = round.fieldOfView();
            double cone = CONE * fieldOfView;
            int steps = Math.max(1, (int) Math.ceil(cone / Surroundings.WIDTH * 2)); // so that it misses no sector
            directions = steps + 1;
            rays = new Rays(round.count() * directions, i -> {
                double angle = cone * ((double) (i % directions) / steps - 0.5);
                return baseFromSonars.get(i / directions).theta() + angle;
            });
        }

        boolean isOf(RangeArray round) {
            return fieldOfView == round.fieldOfView() && baseFromSonars.equals(round.baseFromSensors());
        }
    }

    /// @param limit things farther away than this do not count [m]
    public SectorFusion(double limit) {
        this.limit = limit;
        memory.clear();
        spare.clear();
    }

    /// @param now of this picture, not before that of the last
    public Surroundings fuse(Instant now, Pose2d odomFromBase, Optional<LaserScan> laser, Optional<RangeArray> sonars) {
        float[] ranges = new float[Surroundings.SECTORS];
        Arrays.fill(ranges, Float.NaN);
        laser.ifPresent(scan -> look(scan, ranges));
        System.arraycopy(ranges, 0, seen, 0, seen.length);
        sonars.ifPresent(round -> {
            if (laser.isPresent()) {
                listenBesideLaser(round, ranges);
            } else {
                listen(round, ranges);
            }
        });
        if (laser.isPresent() || remembers) {
            long time = nanos(now);
            recall(time, odomFromBase, ranges);
            remember(time, odomFromBase);
        }
        return new Surroundings(ranges);
    }

    /// Since the epoch.
    private static long nanos(Instant time) {
        return Math.addExact(Math.multiplyExact(time.getEpochSecond(), 1_000_000_000), time.getNano());
    }

    /// Adds what is remembered of sectors that the laser doesn't look into, unless a sonar hears nothing so near. The
    /// rest is forgotten.
    ///
    /// @param now since the epoch [ns]
    private void recall(long now, Pose2d odomFromBase, float[] ranges) {
        System.arraycopy(ranges, 0, sensed, 0, sensed.length);
        Arrays.fill(nearest, Float.NaN);
        long oldest = now - REMEMBERED;
        double cos = Math.cos(odomFromBase.theta());
        double sin = Math.sin(odomFromBase.theta());
        Memory before = memory;
        memory = spare;
        spare = before;
        memory.clear();
        remembers = false;
        for (int i = 0; i < Surroundings.SECTORS; i++) {
            long then = before.seen[i];
            if (then < oldest) { // or never
                continue;
            }
            double dx = before.x[i] - odomFromBase.x();
            double dy = before.y[i] - odomFromBase.y();
            double x = cos * dx + sin * dy;
            double y = cos * dy - sin * dx;
            int sector = Surroundings.sectorOf(x, y, i); // nearly all are where they were
            float range = (float) Math.sqrt(x * x + y * y);
            boolean isStillThere = Float.isNaN(seen[sector]) && !(sensed[sector] > range + SAME);
            if (isStillThere && !(nearest[sector] <= range)) {
                nearest[sector] = range;
                memory.put(sector, before.x[i], before.y[i], then);
                remembers = true;
                ranges[sector] = ranges[sector] <= range ? ranges[sector] : range; // also where nothing was
            }
        }
    }

    /// @param now since the epoch [ns]
    private void remember(long now, Pose2d odomFromBase) {
        double cos = Math.cos(odomFromBase.theta());
        double sin = Math.sin(odomFromBase.theta());
        for (int sector = 0; sector < seen.length; sector++) {
            if (seen[sector] < Float.POSITIVE_INFINITY) {
                double x = seen[sector] * Surroundings.cos(sector);
                double y = seen[sector] * Surroundings.sin(sector);
                memory.put(sector, odomFromBase.x() + cos * x - sin * y, odomFromBase.y() + sin * x + cos * y, now);
                remembers = true;
            }
        }
    }

    private void look(LaserScan scan, float[] ranges) {
        Fan beams = fan;
        if (beams == null || !beams.isOf(scan)) {
            beams = new Fan(scan);
            fan = beams;
        }
        for (int i = 0; i < beams.rays.count(); i++) {
            double range = measured(scan.ranges()[i / beams.copies], scan.rangeMin(), scan.rangeMax());
            if (!Double.isNaN(range)) {
                beams.rays.note(i, beams.baseFromLaser, range, limit, ranges);
            }
        }
    }

    private Cones cones(RangeArray round) {
        Cones known = cones;
        if (known == null || !known.isOf(round)) {
            known = new Cones(round);
            cones = known;
        }
        return known;
    }

    /// Without a laser, all counts that sonars hear.
    private void listen(RangeArray round, float[] ranges) {
        Cones all = cones(round);
        for (int i = 0; i < all.rays.count(); i++) {
            int sonar = i / all.directions;
            double range = measured(round.ranges()[sonar], round.rangeMin(), round.rangeMax());
            if (!Double.isNaN(range)) {
                all.rays.note(i, all.baseFromSonars.get(sonar), range, limit, ranges);
            }
        }
    }

    /// With a laser, only what it does not explain.
    private void listenBesideLaser(RangeArray round, float[] ranges) {
        Cones all = cones(round);
        for (int sonar = 0; sonar < round.count(); sonar++) {
            double range = measured(round.ranges()[sonar], round.rangeMin(), round.rangeMax());
            if (Double.isNaN(range)) {
                continue;
            }
            Pose2d baseFromSonar = all.baseFromSonars.get(sonar);
            int begin = sonar * all.directions;
            int end = begin + all.directions;
            double nearest = Double.POSITIVE_INFINITY; // that the laser sees within the cone, from the sonar [m]
            for (int ray = begin; ray < end; ray++) {
                int sector = all.rays.sector(ray, baseFromSonar, Math.min(range, limit));
                if (seen[sector] < Float.POSITIVE_INFINITY) {
                    double x = seen[sector] * Surroundings.cos(sector) - baseFromSonar.x();
                    double y = seen[sector] * Surroundings.sin(sector) - baseFromSonar.y();
                    nearest = Math.min(nearest, Math.sqrt(x * x + y * y));
                }
            }
            boolean explained = nearest <= range + SAME + SAME_SHARE * range;
            for (int ray = begin; ray < end; ray++) {
                if (!explained || Float.isNaN(seen[all.rays.sectors[ray]])) {
                    all.rays.note(ray, baseFromSonar, range, limit, ranges);
                }
            }
        }
    }

    /// A reading as [Rep117#distance] has it; what is beyond the limit is nothing.
    private double measured(double shown, double least, double most) {
        double range = Rep117.distance(shown, least);
        return range > Math.min(most, limit) ? Double.POSITIVE_INFINITY : range;
    }
}
