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

    /// @param distance forward [m]
    /// @param turn counter-clockwise [rad]
    void moved(double distance, double turn) {
        double way = Math.abs(distance);
        double headingVariance =
                square(noise.headingPerMeter()) * way + square(noise.headingPerRadian()) * Math.abs(turn);
        double distanceError = scale * noise.distancePerMeter() * Math.sqrt(way) * random.nextGaussian();
        double headingError = scale * Math.sqrt(headingVariance) * random.nextGaussian();
        odomFromBase = Arc.ahead(odomFromBase, distance + distanceError, turn + headingError)
                .at(1);
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
