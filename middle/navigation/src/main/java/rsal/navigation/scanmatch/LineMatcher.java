package rsal.navigation.scanmatch;

import java.util.Optional;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// Lays a scan onto the lines on which the points of a reference lie: A. Censi, An ICP variant using a
/// point-to-line metric (ICRA 2008): pairs of nearest points, then the pose with the least squares of distances along
/// the normals of the reference, again and again.
///
/// Differs from the paper in these points:
/// * Each step is one of Gauss and Newton, small turns taken for straight; the paper solves it in closed form.
/// * Pairs that lie apart count less (weights of Cauchy) and are none beyond a distance that shrinks from step to
///   step; the paper trims a share of them.
/// * A line's direction is that of the neighbors within the same scan, not that through the two nearest points.
/// * Pairs whose surfaces face different ways are none. What is on no line counts as a point, a little.
/// * The nearest point is found by cells ([Nearest]), not by tables of jumps along the scan.
///
/// The covariance is not that of A. Censi, An Accurate Closed-Form Estimate of ICP's Covariance (ICRA 2007), but the
/// inverse of the normal equations of pairs on lines alone, as the points of a long wall seen from afar are on none and
/// lie near each other by chance; for a deviation of at least [#LEAST_DEVIATION], as if each [#ALIKE] pairs told the
/// same, and for what they say nothing about that of [#VAGUE_METERS] and [#VAGUE_RADIANS].
///
/// Immutable; may be shared between threads.
public final class LineMatcher {
    /// How far points are off lines at least [m].
    public static final double LEAST_DEVIATION = 0.015;

    /// How far pairs err together, as beams of one scan do.
    public static final double ALIKE = 4;

    /// Deviation along what has no structure [m].
    public static final double VAGUE_METERS = 1;

    /// The same of a heading [rad].
    public static final double VAGUE_RADIANS = 0.5;

    private static final int STEPS = 30;
    private static final double FARTHEST = 0.4; // m; pairs at first
    private static final double NARROWEST = 0.12; // m; in the end
    private static final double NARROWING = 0.8;
    private static final double FACING = 0.7; // cosine
    private static final int FEWEST = 15; // pairs
    private static final double DONE_METERS = 1e-4;
    private static final double DONE_RADIANS = 1e-5;
    private static final double POINT = 0.2; // of points of the reference that are
    private static final double ALONE = 0.2; // weight of points that are on no line
    private static final double WIDTH = 0.03; // m; where weights are half

    private final Cloud reference;
    private final Nearest nearest;

    /// @param reference in frame `a`
    public LineMatcher(Cloud reference) {
        this.reference = reference;
        this.nearest = new Nearest(reference);
    }

    /// Where the scan lies best near a guess.
    ///
    /// @param scan in frame `b`
    /// @param guess where `b` is in `a`, right to some decimeters and degrees
    /// @return with the share of the scan's points that lie where points are as its score; empty when too few
    /// lie on lines
    public Optional<Match> match(Cloud scan, Pose2d guess) {
        return match(scan, guess, FARTHEST);
    }

    /// The same for a guess that is better than that.
    ///
    /// @param farthest that points of a pair may be apart at first [m]
    public Optional<Match> match(Cloud scan, Pose2d guess, double farthest) {
        Pose2d pose = guess;
        double within = Math.min(FARTHEST, farthest);
        var equations = new Equations();
        for (int step = 0; step < STEPS; step++) {
            equations.clear();
            pair(scan, pose, within, equations);
            if (equations.pairs < FEWEST) {
                return Optional.empty();
            }
            double[] change = equations.solve();
            if (!(Math.hypot(change[0], change[1]) < 2 * FARTHEST)) {
                return Optional.empty();
            }
            pose = new Pose2d(pose.x() + change[0], pose.y() + change[1], pose.theta() + change[2]);
            boolean still = Math.hypot(change[0], change[1]) < DONE_METERS && Math.abs(change[2]) < DONE_RADIANS;
            if (still && within <= NARROWEST) {
                break;
            }
            within = Math.max(NARROWEST, within * NARROWING);
        }
        return pose.isFinite()
                ? Optional.of(
                        new Match(pose, equations.covariance(), (double) equations.alike / Math.max(1, scan.count())))
                : Optional.empty();
    }

    private void pair(Cloud scan, Pose2d pose, double within, Equations equations) {
        double cos = Math.cos(pose.theta());
        double sin = Math.sin(pose.theta());
        for (int i = 0; i < scan.count(); i++) {
            double turnedX = cos * scan.x[i] - sin * scan.y[i];
            double turnedY = sin * scan.x[i] + cos * scan.y[i];
            int other = nearest.find(pose.x() + turnedX, pose.y() + turnedY, within);
            if (other < 0) {
                continue;
            }
            double normalX = reference.normalX[other];
            double normalY = reference.normalY[other];
            double offX = reference.x[other] - pose.x() - turnedX;
            double offY = reference.y[other] - pose.y() - turnedY;
            if (Double.isNaN(normalX)) {
                equations.alike++;
                equations.add(1, 0, -turnedY, offX, POINT, false);
                equations.add(0, 1, turnedX, offY, POINT, false);
                continue;
            }
            double facing = normalX * (cos * scan.normalX[i] - sin * scan.normalY[i])
                    + normalY * (sin * scan.normalX[i] + cos * scan.normalY[i]);
            if (!(facing < FACING)) { // nor NaN
                equations.pairs++;
                equations.alike++;
                double off = normalX * offX + normalY * offY;
                boolean line = !Double.isNaN(facing);
                double byTheta = normalY * turnedX - normalX * turnedY;
                equations.add(normalX, normalY, byTheta, off, line ? 1 : ALONE, line);
            }
        }
    }

    /// Weighted normal equations for a change of x, y and heading.
    private static final class Equations {
        private final Sums all = new Sums();
        private final Sums onLines = new Sums();
        private double x;
        private double y;
        private double t;
        private double squares;
        private double weights;
        private int pairs; // with a line
        private int alike; // points where points are, on a line or not

        void clear() {
            all.clear();
            onLines.clear();
            x = 0;
            y = 0;
            t = 0;
            squares = 0;
            weights = 0;
            pairs = 0;
            alike = 0;
        }

        /// @param line whether both points are on one
        void add(double byX, double byY, double byTheta, double off, double share, boolean line) {
            double weight = share / (1 + off * off / (WIDTH * WIDTH));
            all.add(byX, byY, byTheta, weight);
            if (line) {
                onLines.add(byX, byY, byTheta, weight);
            }
            x += weight * byX * off;
            y += weight * byY * off;
            t += weight * byTheta * off;
            squares += weight * off * off;
            weights += weight;
        }

        double[] solve() {
            Covariance2d inverse = all.values().inverse();
            return new double[] {
                inverse.xx() * x + inverse.xy() * y + inverse.xTheta() * t,
                inverse.xy() * x + inverse.yy() * y + inverse.yTheta() * t,
                inverse.xTheta() * x + inverse.yTheta() * y + inverse.thetaTheta() * t
            };
        }

        Covariance2d covariance() {
            double variance = Math.max(LEAST_DEVIATION * LEAST_DEVIATION, squares / weights);
            return onLines.values().inverse().times(variance * ALIKE);
        }
    }

    /// The symmetric side of the equations.
    private static final class Sums {
        private double xx;
        private double xy;
        private double xt;
        private double yy;
        private double yt;
        private double tt;

        void clear() {
            double vague = LEAST_DEVIATION * LEAST_DEVIATION * ALIKE;
            xx = vague / (VAGUE_METERS * VAGUE_METERS);
            yy = xx;
            tt = vague / (VAGUE_RADIANS * VAGUE_RADIANS);
            xy = 0;
            xt = 0;
            yt = 0;
        }

        void add(double byX, double byY, double byTheta, double weight) {
            xx += weight * byX * byX;
            xy += weight * byX * byY;
            xt += weight * byX * byTheta;
            yy += weight * byY * byY;
            yt += weight * byY * byTheta;
            tt += weight * byTheta * byTheta;
        }

        Covariance2d values() {
            return new Covariance2d(xx, xy, xt, yy, yt, tt);
        }
    }
}
