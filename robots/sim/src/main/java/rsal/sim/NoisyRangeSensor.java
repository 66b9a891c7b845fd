package rsal.sim;

import java.time.Duration;
import java.util.random.RandomGenerator;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.RangeNoise;

/// What laser scanners and sonars have in common: what they measure is noisy.
abstract class NoisyRangeSensor<T> extends SimRangeSensor<T> {
    private final Noise noise;

    NoisyRangeSensor(DeviceInfo info, String frame, Duration period, DeviceMount mount, Noise noise) {
        super(info, frame, period, mount);
        this.noise = noise;
    }

    /// A true range [m], as the sensor shows it (REP 117).
    float shown(double range, double min, double max) {
        if (range > max) {
            return Float.POSITIVE_INFINITY;
        }
        double noisy = noise.on(range);
        if (range < min || noisy < min) {
            return Float.NEGATIVE_INFINITY;
        }
        return noisy > max ? Float.POSITIVE_INFINITY : (float) noisy;
    }

    Noise noise() {
        return noise;
    }

    /// Errors of ranges, as drawn.
    record Noise(RangeNoise size, RandomGenerator random) {
        /// A range [m] with its error.
        double on(double range) {
            double noisy = range + size.deviation() * random.nextGaussian();
            return size.share() == 0 ? noisy : noisy + range * evenly(size.share());
        }

        /// How far a beam is turned [rad].
        double turn() {
            return evenly(size.angle());
        }

        private double evenly(double most) {
            return most * (2 * random.nextDouble() - 1);
        }
    }
}
