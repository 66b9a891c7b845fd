package rsal.navigation.amcl;

import java.util.random.RandomGenerator;
import rsal.data.Angles;
import rsal.data.Pose2d;

/// How wrong odometry may be: a turn, a way, another turn, each with Gaussian noise. Thrun, Burgard, Fox,
/// Probabilistic Robotics, table 5.6.
///
/// Differs from the book in that variances grow with the way and the turn made, not with their squares: two steps
/// of 5 cm are then as uncertain as one of 10 cm, however often the filter looks. Driving backwards is a way of
/// negative length, not two half turns, and the direction of ways under a millimeter is not asked for.
///
/// @param distancePerMeter standard deviation of the way [m/√m] (α₃ in the book)
/// @param headingPerMeter standard deviation of the heading from driving [rad/√m] (α₂)
/// @param headingPerRadian standard deviation of the heading from turning [rad/√rad] (α₁)
public record OdometryModel(double distancePerMeter, double headingPerMeter, double headingPerRadian) {
    private static final double NO_WAY = 1e-3;

    /// Moves particles as odometry says that the robot moved, each with noise of its own.
    void move(Pose2d odomFromOld, Pose2d odomFromNew, Particles particles, RandomGenerator random) {
        double dx = odomFromNew.x() - odomFromOld.x();
        double dy = odomFromNew.y() - odomFromOld.y();
        double way = Math.hypot(dx, dy);
        double turn = Angles.difference(odomFromOld.theta(), odomFromNew.theta());
        double firstTurn = way < NO_WAY ? turn / 2 : Angles.wrap(Math.atan2(dy, dx) - odomFromOld.theta());
        if (Math.abs(firstTurn) > Math.PI / 2 && way >= NO_WAY) {
            firstTurn = Angles.wrap(firstTurn + Math.PI);
            way = -way;
        }
        double secondTurn = Angles.wrap(turn - firstTurn);

        double length = Math.abs(way);
        double wayNoise = distancePerMeter * Math.sqrt(length);
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
}
