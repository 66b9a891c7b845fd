package rsal.navigation.amcl;

import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// By what factor odometry is wrong, and what this means where scans do not tell how far the robot went.
///
/// A wheel of the wrong size makes each way too long by the same factor, which noise that is different for each step
/// does not describe: its deviation grows with the root of the way, the error with the way. The factor is a constant
/// that is estimated by a scalar Kalman filter: each stretch of about a meter which is seen well from both ends is a
/// measurement. It is used once it differs from 1 by more than chance. As its own error is in all steps alike, what it
/// does to the position is kept as a sensitivity [m], which grows with the way and shrinks along what scans tell: the
/// factor is *considered*, S. Schmidt, Applications of State-Space Methods to Navigation Problems (Advances in Control
/// Systems 3, 1966). Along a corridor it only grows.
///
/// Not safe for several threads at once.
final class OdometryScale {
    private static final double STRETCH = 1; // m
    private static final double MOST_TURN = 0.6; // rad, of a stretch: turns may be wrong, too
    private static final double TURN = 1.5; // rad, of a turn that is measured
    private static final double SEEN = 0.12; // m, standard deviation of the pose where a stretch begins and ends
    private static final double POSE_DEVIATION = 0.05; // m, of what scans say of a pose
    private static final double HEADING_DEVIATION = 0.04; // rad, the same
    private static final double UNKNOWN = 0.1; // standard deviation of the factor at first
    private static final double INDEPENDENT = 0.3; // share of what a scan tells that those before it did not
    private static final double SPREAD = 0.3; // share of the variance that particles get: more of them drift by chance
    private static final double LEAST_DRIFT = 0.1; // m, below which noise is more than enough
    private static final double CHANGE = 0.005; // of the factor, from one stretch to the next
    private static final double LEAST_CHANGE = 0.05; // below which it is not used
    private static final double SURE = 3; // deviations
    private static final double FARTHEST = 0.4; // of a factor from 1

    private double distance = 1;
    private double distanceVariance = UNKNOWN * UNKNOWN;
    private double turn = 1;
    private double turnVariance = UNKNOWN * UNKNOWN;
    private boolean begun;
    private Pose2d began = Pose2d.ORIGIN;
    private Pose2d odometry = Pose2d.ORIGIN; // since the stretch began
    private double way;
    private double turned;
    private double turnedEither; // to the left and to the right together
    private double alongX; // m for each unit of the factor, in the map
    private double alongY;

    /// Forgets where it is, but not the factors: they belong to the wheels.
    void restart() {
        begun = false;
        alongX = 0;
        alongY = 0;
    }

    /// Whether motions are to be corrected.
    boolean isWrong() {
        return distanceFactor() != 1 || turnFactor() != 1;
    }

    /// What a motion was that odometry reports.
    Pose2d corrected(Pose2d motion) {
        double factor = distanceFactor();
        return new Pose2d(factor * motion.x(), factor * motion.y(), turnFactor() * motion.theta());
    }

    double distanceFactor() {
        return factor(distance, distanceVariance);
    }

    double turnFactor() {
        return factor(turn, turnVariance);
    }

    private static double factor(double estimate, double variance) {
        double by = Math.abs(estimate - 1);
        return by > LEAST_CHANGE && by > SURE * Math.sqrt(variance) ? estimate : 1;
    }

    /// Takes up a motion.
    ///
    /// @param motion as odometry reports it
    /// @param theta heading in the map before it
    /// @return variance of the way [m²] to be added to that of noise
    double move(Pose2d motion, double theta) {
        odometry = odometry.compose(motion);
        way += Math.hypot(motion.x(), motion.y());
        turned += motion.theta();
        turnedEither += Math.abs(motion.theta());
        double before = alongX * alongX + alongY * alongY;
        double cos = Math.cos(theta + motion.theta() / 2);
        double sin = Math.sin(theta + motion.theta() / 2);
        alongX += cos * motion.x() - sin * motion.y();
        alongY += sin * motion.x() + cos * motion.y();
        double more = alongX * alongX + alongY * alongY - before;
        return drift() > LEAST_DRIFT ? SPREAD * Math.max(0, deviation() * deviation() * more) : 0;
    }

    private double deviation() {
        return Math.sqrt(distanceVariance);
    }

    /// What the factor's error does to the position [m].
    double drift() {
        return deviation() * Math.hypot(alongX, alongY);
    }

    /// Takes up where scans say that the robot is.
    ///
    /// @param covariance of the particles
    /// @param isRight whether scans speak for the pose
    void see(Pose2d pose, Covariance2d covariance, boolean isRight) {
        boolean seen = isRight && covariance.positionDeviation() < SEEN && drift() < SEEN;
        if (!seen) {
            begun = false;
        } else if (!begun) {
            begin(pose);
        } else if (Math.abs(turned) >= TURN) {
            measureTurn(pose);
            begin(pose);
        } else if (way >= STRETCH) {
            if (turnedEither < MOST_TURN) {
                measureDistance(pose);
                begin(pose);
            } else if (Math.abs(turned) < MOST_TURN) {
                begin(pose);
            } else if (way >= 3 * STRETCH) {
                begin(pose);
            }
        }
    }

    private void begin(Pose2d pose) {
        begun = true;
        began = pose;
        odometry = Pose2d.ORIGIN;
        way = 0;
        turned = 0;
        turnedEither = 0;
    }

    private void measureDistance(Pose2d pose) {
        double reported = Math.hypot(odometry.x(), odometry.y());
        if (reported < STRETCH / 2) {
            return;
        }
        double measured = began.distanceTo(pose) / reported;
        double variance = 2 * POSE_DEVIATION * POSE_DEVIATION / (reported * reported);
        distanceVariance += CHANGE * CHANGE;
        double gain = distanceVariance / (distanceVariance + variance);
        distance = Math.clamp(distance + gain * (measured - distance), 1 - FARTHEST, 1 + FARTHEST);
        distanceVariance *= 1 - gain;
    }

    private void measureTurn(Pose2d pose) {
        double made = began.theta() + turned; // near it, but for whole turns
        double measured = (turned + Angles.difference(made, pose.theta())) / turned;
        double variance = 2 * HEADING_DEVIATION * HEADING_DEVIATION / (turned * turned);
        turnVariance += CHANGE * CHANGE;
        double gain = turnVariance / (turnVariance + variance);
        turn = Math.clamp(turn + gain * (measured - turn), 1 - FARTHEST, 1 + FARTHEST);
        turnVariance *= 1 - gain;
    }

    /// Takes up what a scan tells: (I + M J)⁻¹ times the sensitivity. M is what was not known of the position, J what
    /// the scan tells of it when the heading is not known either.
    ///
    /// @param covariance of the particles
    /// @param sums what the scan tells of the pose, as [Refinement#add] returns it
    void shrink(Covariance2d covariance, double[] sums) {
        double headings = Math.max(1e-9, sums[5]);
        double jxx = INDEPENDENT * Math.max(0, sums[0] - sums[2] * sums[2] / headings);
        double jxy = INDEPENDENT * (sums[1] - sums[2] * sums[4] / headings);
        double jyy = INDEPENDENT * Math.max(0, sums[3] - sums[4] * sums[4] / headings);
        double variance = deviation() * deviation();
        double mxx = covariance.xx() + variance * alongX * alongX;
        double mxy = covariance.xy() + variance * alongX * alongY;
        double myy = covariance.yy() + variance * alongY * alongY;
        double a = 1 + mxx * jxx + mxy * jxy;
        double b = mxx * jxy + mxy * jyy;
        double c = mxy * jxx + myy * jxy;
        double d = 1 + mxy * jxy + myy * jyy;
        double determinant = a * d - b * c;
        if (determinant > 0.5) {
            double x = (d * alongX - b * alongY) / determinant;
            double y = (a * alongY - c * alongX) / determinant;
            alongX = x;
            alongY = y;
        }
    }
}
