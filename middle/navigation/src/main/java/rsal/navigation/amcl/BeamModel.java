package rsal.navigation.amcl;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import rsal.navigation.grid.DistanceField;

/// How likely beams are as long as they are, when the map says how long they should be: S. Thrun, W. Burgard,
/// D. Fox, Probabilistic Robotics (2005), table 6.1.
///
/// Differs from the book in that beams that hit nothing are left out, so there is no z_max; in that the bell of
/// hits has height 1, not area 1, so that a likelihood is no density but 0.9 where a beam is exactly as long as
/// it should be; in that a beam that leaves the map may have any length; in what ends outside the map
/// ([OutOfMapModel]); and in that a beam may be a cone, as a sonar's is, which should be as long as the
/// shortest ray in it ([Cones]).
public final class BeamModel implements SensorModel {
    private static final double SHORT_SHARE = 0.1; // z_short, of the height of the bell
    private static final double SHORT_DECAY = 0.3; // λ_short in the book, 1/m
    private static final double FARTHEST = 4; // deviations
    private static final double STEPS_PER_RADIAN = Cones.DIRECTIONS / (2 * Math.PI);
    private static final int BELL_STEPS = 1024;
    private static final double SMALL = 1e-100; // far from what a number can hold

    private final DistanceField toOccupied;
    private final OutOfMapModel around;
    private final double deviation;
    private final double randomShare;
    private final Map<Integer, Cones> cones = new ConcurrentHashMap<>(); // by rays on each side
    private final double[] bell = new double[BELL_STEPS + 2]; // of hits, by how far they are off; 0 in the end
    private final double bellStepsPerMeter;

    /// @param deviation how far beams are from as long as they should be, σ_hit in the book [m]
    /// @param randomShare of readings that have nothing to do with the map, z_rand in the book
    BeamModel(DistanceField toOccupied, OutOfMapModel around, double deviation, double randomShare) {
        this.toOccupied = toOccupied;
        this.around = around;
        this.deviation = deviation;
        this.randomShare = randomShare;
        this.bellStepsPerMeter = BELL_STEPS / (FARTHEST * deviation);
        for (int i = 0; i < BELL_STEPS; i++) {
            double deviations = (i + 0.5) / BELL_STEPS * FARTHEST;
            bell[i] = (1 - randomShare - SHORT_SHARE) * Math.exp(-deviations * deviations / 2);
        }
    }

    @Override
    public double log(Beams beams, double x, double y, double theta) {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        Cones cones = beams.cone() > 0 ? cones(beams.cone()) : null;
        double onMap = 0;
        double product = 1; // of likelihoods whose logarithms are not yet in the sum
        double beyond = 0;
        int outside = 0;
        for (int i = 0; i < beams.count(); i++) {
            double dx = beams.x()[i] - beams.originX()[i];
            double dy = beams.y()[i] - beams.originY()[i];
            double measured = Math.sqrt(dx * dx + dy * dy);
            double fromX = x + cos * beams.originX()[i] - sin * beams.originY()[i];
            double fromY = y + sin * beams.originX()[i] + cos * beams.originY()[i];
            double toX = (cos * dx - sin * dy) / measured;
            double toY = (sin * dx + cos * dy) / measured;
            double limit = measured + FARTHEST * deviation; // farther ones do not count
            double expected = cones == null
                    ? toOccupied.firstHit(fromX, fromY, toX, toY, limit)
                    : cones.exact(fromX, fromY, toX, toY, limit);
            double likelihood = likelihood(measured, expected);
            if (expected == Double.POSITIVE_INFINITY
                    && !toOccupied.contains(fromX + toX * measured, fromY + toY * measured)) {
                beyond += Math.log(likelihood);
                outside++;
                continue;
            }
            product *= likelihood;
            if (product < SMALL) {
                onMap += Math.log(product);
                product = 1;
            }
        }
        return around.joined(onMap + Math.log(product), beams.count() - outside, beyond, outside);
    }

    /// The same for the poses of all particles; of cones as [Cones] remembers them, which is off by some centimeters
    /// and some ten times as fast.
    void logs(Beams beams, Particles particles, PoseBlock block, double[] into) {
        if (beams.cone() > 0) {
            logsOfCones(new Rays(beams), cones(beams.cone()), particles, block, into);
            return;
        }
        for (int i = 0; i < particles.count; i++) {
            into[i] = log(beams, particles.x[i], particles.y[i], particles.theta[i]);
        }
    }

    /// What of beams is the same for all poses.
    private static final class Rays {
        final int count;
        final float[] originX;
        final float[] originY;
        final float[] toX; // direction, a vector of length 1
        final float[] toY;
        final double[] direction; // in steps of cones
        final double[] measured; // m
        final double[] tooShort; // likelihood, if it should be longer

        Rays(Beams beams) {
            count = beams.count();
            originX = beams.originX();
            originY = beams.originY();
            toX = new float[count];
            toY = new float[count];
            direction = new double[count];
            measured = new double[count];
            tooShort = new double[count];
            for (int i = 0; i < count; i++) {
                double dx = beams.x()[i] - beams.originX()[i];
                double dy = beams.y()[i] - beams.originY()[i];
                double length = Math.sqrt(dx * dx + dy * dy);
                toX[i] = (float) (dx / length);
                toY[i] = (float) (dy / length);
                direction[i] = Math.atan2(dy, dx) * STEPS_PER_RADIAN;
                measured[i] = length;
                tooShort[i] = tooShort(length);
            }
        }
    }

    private void logsOfCones(Rays rays, Cones cones, Particles particles, PoseBlock block, double[] into) {
        for (int first = 0; first < particles.count; first += PoseBlock.SIZE) {
            int count = Math.min(PoseBlock.SIZE, particles.count - first);
            block.take(particles, first, count, cones.originX, cones.originY, cones.cellsPerMeter);
            for (int i = 0; i < count; i++) {
                into[first + i] = log(
                        rays, cones, block.x[i], block.y[i], block.cos[i], block.sin[i], particles.theta[first + i]);
            }
        }
    }

    /// @param x in cells of the cones, as y; the cosine and sine are times cells per meter
    private double log(Rays rays, Cones cones, float x, float y, float cos, float sin, double theta) {
        float cellsPerMeter = (float) cones.cellsPerMeter;
        float metersPerCell = 1 / cellsPerMeter;
        // Two turns more than nothing: what is cut to a whole number is then never negative.
        double heading = theta * STEPS_PER_RADIAN + 2 * Cones.DIRECTIONS + 0.5;
        double onMap = 0;
        double product = 1; // of likelihoods whose logarithms are not yet in the sum
        double beyond = 0;
        int outside = 0;
        for (int i = 0; i < rays.count; i++) {
            float column = x + cos * rays.originX[i] - sin * rays.originY[i];
            float row = y + sin * rays.originX[i] + cos * rays.originY[i];
            float toX = (cos * rays.toX[i] - sin * rays.toY[i]) * metersPerCell;
            float toY = (sin * rays.toX[i] + cos * rays.toY[i]) * metersPerCell;
            int direction = (int) (heading + rays.direction[i]) % Cones.DIRECTIONS;
            double measured = rays.measured[i];
            double expected = cones.reach(column, row, toX, toY, direction, measured + FARTHEST * deviation);
            double off = Math.min(Math.abs(measured - expected) * bellStepsPerMeter, BELL_STEPS);
            double likelihood = bell[(int) off] + (measured < expected ? rays.tooShort[i] : 0) + randomShare;
            if (expected == Double.POSITIVE_INFINITY
                    && around.isUnknown()
                    && !toOccupied.contains(
                            cones.originX + column * metersPerCell + toX * measured,
                            cones.originY + row * metersPerCell + toY * measured)) {
                beyond += Math.log(likelihood);
                outside++;
                continue;
            }
            product *= likelihood;
            if (product < SMALL) {
                onMap += Math.log(product);
                product = 1;
            }
        }
        return around.joined(onMap + Math.log(product), rays.count - outside, beyond, outside);
    }

    private Cones cones(double width) {
        return cones.computeIfAbsent(Cones.raysAside(width), aside -> new Cones(toOccupied, aside));
    }

    /// Below 1, and never less than the share of random readings.
    ///
    /// @param expected +∞ when the map shows nothing there
    double likelihood(double measured, double expected) {
        double deviations = (measured - expected) / deviation;
        double hit = Math.exp(-deviations * deviations / 2);
        double tooShort = measured < expected ? tooShort(measured) : 0;
        return (1 - randomShare - SHORT_SHARE) * hit + tooShort + randomShare;
    }

    private static double tooShort(double measured) {
        return SHORT_SHARE * Math.exp(-SHORT_DECAY * measured);
    }
}
