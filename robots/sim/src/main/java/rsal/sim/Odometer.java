package rsal.sim;

import java.util.random.RandomGenerator;
import rsal.data.Pose2d;
import rsal.robot.RobotModel;
import rsal.sim.world.Arc;

/// Where the wheels say the robot is. Errors are random walks over the way and the turn made: their variance grows
/// with both, so that the length of a step does not matter.
final class Odometer {
    private final RobotModel.OdometryNoise noise;
    private final double scale;
    private final RandomGenerator random;
    private Pose2d odomFromBase = Pose2d.ORIGIN;

    /// @param scale of the noise; 0 makes it perfect
    Odometer(RobotModel.OdometryNoise noise, double scale, RandomGenerator random) {
        this.noise = noise;
        this.scale = scale;
        this.random = random;
    }

    /// @param forward [m]
    /// @param left [m]; errors are along the way made
    /// @param turn counter-clockwise [rad]
    void moved(double forward, double left, double turn) {
        double distance = left == 0 ? Math.abs(forward) : Math.sqrt(forward * forward + left * left);
        double headingVariance =
                square(noise.headingPerMeter()) * distance + square(noise.headingPerRadian()) * Math.abs(turn);
        double distanceError = scale * noise.distancePerMeter() * Math.sqrt(distance) * random.nextGaussian();
        double headingError = scale * Math.sqrt(headingVariance) * random.nextGaussian();
        double longer = distance == 0 ? 1 : 1 + distanceError / distance;
        odomFromBase = new Arc(odomFromBase, forward * longer, left * longer, turn + headingError).at(1);
    }

    void reset(Pose2d now) {
        odomFromBase = now;
    }

    Pose2d odomFromBase() {
        return odomFromBase;
    }

    private static double square(double x) {
        return x * x;
    }
}
