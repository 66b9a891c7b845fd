package rsal.navigation.amcl;

import java.util.random.RandomGenerator;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// How wrong odometry may be: a turn, a way, another turn, each with Gaussian noise. Thrun, Burgard, Fox,
/// Probabilistic Robotics, table 5.6.
///
/// Differs from the book in that variances grow with the way and the turn made, not with their squares: two steps
/// of 5 cm are then as uncertain as one of 10 cm, however often the filter looks. Driving backwards is a way of
/// negative length, not two half turns, and the direction of ways under a millimeter is not asked for.
///
/// An omnidirectional base may turn while it goes any way, so its heading has nothing to do with the direction of
/// the way: one way and one turn, with noise along the way, across it and of the heading, as in the omnidirectional
/// model of Player's and ROS's `amcl`.
///
/// @param distancePerMeter standard deviation of the way [m/√m] (α₃ in the book)
/// @param headingPerMeter standard deviation of the heading from driving [rad/√m] (α₂)
/// @param headingPerRadian standard deviation of the heading from turning [rad/√rad] (α₁)
/// @param sidewaysPerMeter standard deviation across the way [m/√m]; only for omnidirectional bases
/// @param base how the robot drives
public record OdometryModel(
        double distancePerMeter, double headingPerMeter, double headingPerRadian, double sidewaysPerMeter, Base base) {
    private static final double NO_MOTION = 1e-3;

    /// How a robot drives.
    public enum Base {
        /// Where it looks, or backwards.
        DIFFERENTIAL,
        /// Any way.
        OMNIDIRECTIONAL
    }

    public OdometryModel {
        if (!(isPossible(distancePerMeter)
                && isPossible(headingPerMeter)
                && isPossible(headingPerRadian)
                && isPossible(sidewaysPerMeter))) {
            throw new IllegalArgumentException("Noise must be finite and not below 0: (%s, %s, %s, %s)."
                    .formatted(distancePerMeter, headingPerMeter, headingPerRadian, sidewaysPerMeter));
        }
    }

    private static boolean isPossible(double noise) {
        return noise >= 0 && noise < Double.POSITIVE_INFINITY;
    }

    /// Of a base that drives where it looks.
    public OdometryModel(double distancePerMeter, double headingPerMeter, double headingPerRadian) {
        this(distancePerMeter, headingPerMeter, headingPerRadian, 0, Base.DIFFERENTIAL);
    }

    /// Where a robot may be now that was at a pose when odometry was at the old one.
    public Pose2d sample(Pose2d pose, Pose2d odomFromOld, Pose2d odomFromNew, RandomGenerator random) {
        var one = new Particles(1);
        one.add(pose.x(), pose.y(), pose.theta());
        move(odomFromOld, odomFromNew, one, random);
        return new Pose2d(one.x[0], one.y[0], one.theta[0]);
    }

    /// How uncertain a pose becomes by a way, roughly.
    Covariance2d covariance(Pose2d way) {
        double length = Math.hypot(way.x(), way.y());
        double position = distancePerMeter * distancePerMeter * length
                + sidewaysPerMeter * sidewaysPerMeter * length
                + headingPerMeter * headingPerMeter * length * length * length / 3;
        double heading = headingPerMeter * headingPerMeter * length
                + headingPerRadian * headingPerRadian * Math.abs(way.theta());
        return new Covariance2d(position, 0, 0, position, 0, heading);
    }

    /// Moves particles as odometry says that the robot moved, each with noise of its own.
    void move(Pose2d odomFromOld, Pose2d odomFromNew, Particles particles, RandomGenerator random) {
        move(odomFromOld, odomFromNew, 0, particles, random);
    }

    /// The same with more noise along the way.
    ///
    /// @param more variance [m²]
    void move(Pose2d odomFromOld, Pose2d odomFromNew, double more, Particles particles, RandomGenerator random) {
        if (base == Base.OMNIDIRECTIONAL) {
            slide(odomFromOld.inverse().compose(odomFromNew), more, particles, random);
            return;
        }
        double dx = odomFromNew.x() - odomFromOld.x();
        double dy = odomFromNew.y() - odomFromOld.y();
        double way = Math.hypot(dx, dy);
        double turn = Angles.difference(odomFromOld.theta(), odomFromNew.theta());
        double firstTurn = way < NO_MOTION ? turn / 2 : Angles.wrap(Math.atan2(dy, dx) - odomFromOld.theta());
        if (Math.abs(firstTurn) > Math.PI / 2 && way >= NO_MOTION) {
            firstTurn = Angles.wrap(firstTurn + Math.PI);
            way = -way;
        }
        double secondTurn = Angles.wrap(turn - firstTurn);

        double length = Math.abs(way);
        double wayNoise = alongNoise(length, more);
        double drivingNoise = headingPerMeter * headingPerMeter * length / 2; // half of it before, half after
        double turningNoise = headingPerRadian * headingPerRadian;
        double firstNoise = Math.sqrt(drivingNoise + turningNoise * Math.abs(firstTurn));
        double secondNoise = Math.sqrt(drivingNoise + turningNoise * Math.abs(secondTurn));
        for (int i = 0; i < particles.count; i++) {
            double direction = particles.theta[i] + firstTurn + firstNoise * random.nextGaussian();
            double made = way + wayNoise * random.nextGaussian();
            particles.x[i] += made * Math.cos(direction);
            particles.y[i] += made * Math.sin(direction);
            particles.theta[i] = Angles.wrap(direction + secondTurn + secondNoise * random.nextGaussian());
        }
    }

    private double alongNoise(double length, double more) {
        double usual = distancePerMeter * Math.sqrt(length);
        return more > 0 ? Math.sqrt(usual * usual + more) : usual;
    }

    private void slide(Pose2d way, double more, Particles particles, RandomGenerator random) {
        double length = Math.hypot(way.x(), way.y());
        double bearing = length < NO_MOTION ? 0 : Math.atan2(way.y(), way.x());
        double alongNoise = alongNoise(length, more);
        double acrossNoise = sidewaysPerMeter * Math.sqrt(length);
        double turn = way.theta();
        double turnNoise = Math.sqrt(
                headingPerMeter * headingPerMeter * length + headingPerRadian * headingPerRadian * Math.abs(turn));
        for (int i = 0; i < particles.count; i++) {
            double along = length + alongNoise * random.nextGaussian();
            double across = acrossNoise * random.nextGaussian();
            double wrong = turnNoise * random.nextGaussian();
            double direction = particles.theta[i] + bearing + wrong / 2; // it turned wrong on its way
            double cos = Math.cos(direction);
            double sin = Math.sin(direction);
            particles.x[i] += cos * along - sin * across;
            particles.y[i] += sin * along + cos * across;
            particles.theta[i] = Angles.wrap(particles.theta[i] + turn + wrong);
        }
    }
}
