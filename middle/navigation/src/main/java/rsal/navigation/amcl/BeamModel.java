package rsal.navigation.amcl;

import rsal.navigation.grid.DistanceField;

/// How likely beams are as long as they are, when the map says how long they should be: S. Thrun, W. Burgard, D. Fox,
/// Probabilistic Robotics (2005), table 6.1.
///
/// Differs from the book in that beams that hit nothing are left out, so there is no z_max; in that the
/// bell of hits has height 1, not area 1, so that a likelihood is no density but 0.9 where a beam is exactly as long
/// as it should be; in that a beam that leaves the map may have any length; in what ends outside the map ([Outside]);
/// and in that a beam may be a cone, as a sonar's is, which should be as long as the shortest of three rays in it.
public final class BeamModel implements SensorModel {
    private static final double SHORT_SHARE = 0.1; // z_short, of the height of the bell
    private static final double SHORT_DECAY = 0.3; // λ_short in the book, 1/m
    private static final double FARTHEST = 4; // deviations
    private static final double SIDE_RAY = 0.35; // of the cone, from its middle
    private static final double SMALL = 1e-100; // far from what a number can hold

    private final DistanceField toOccupied;
    private final Outside around;
    private final double deviation;
    private final double randomShare;

    /// @param deviation how far beams are from as long as they should be, σ_hit in the book [m]
    /// @param randomShare of readings that have nothing to do with the map, z_rand in the book
    BeamModel(DistanceField toOccupied, Outside around, double deviation, double randomShare) {
        this.toOccupied = toOccupied;
        this.around = around;
        this.deviation = deviation;
        this.randomShare = randomShare;
    }

    @Override
    public double log(Beams beams, double x, double y, double theta) {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        double sideCos = Math.cos(SIDE_RAY * beams.cone());
        double sideSin = Math.sin(SIDE_RAY * beams.cone());
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
            double expected = toOccupied.firstHit(fromX, fromY, toX, toY, measured + FARTHEST * deviation);
            if (beams.cone() > 0) {
                double nearer = Math.min(expected, measured + FARTHEST * deviation); // farther ones do not count
                double left = toOccupied.firstHit(
                        fromX, fromY, sideCos * toX - sideSin * toY, sideSin * toX + sideCos * toY, nearer);
                double right = toOccupied.firstHit(
                        fromX,
                        fromY,
                        sideCos * toX + sideSin * toY,
                        sideCos * toY - sideSin * toX,
                        Math.min(nearer, left));
                expected = Math.min(expected, Math.min(left, right));
            }
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

    /// The same for the poses of all particles.
    void logs(Beams beams, Particles particles, double[] into) {
        for (int i = 0; i < particles.count; i++) {
            into[i] = log(beams, particles.x[i], particles.y[i], particles.theta[i]);
        }
    }

    /// Below 1, and never less than the share of random readings.
    ///
    /// @param expected +∞ when the map shows nothing there
    double likelihood(double measured, double expected) {
        double deviations = (measured - expected) / deviation;
        double hit = Math.exp(-deviations * deviations / 2);
        double tooShort = measured < expected ? SHORT_SHARE * Math.exp(-SHORT_DECAY * measured) : 0;
        return (1 - randomShare - SHORT_SHARE) * hit + tooShort + randomShare;
    }
}
