package rsal.sim;

import java.time.Duration;
import java.util.random.RandomGenerator;
import rsal.device.DeviceInfo;

/// What laser scanners and sonars have in common: what they measure is noisy.
abstract class RangeSensor<T> extends SimEye<T> {
    private final Noise noise;

    RangeSensor(DeviceInfo info, String frame, Duration period, Noise noise) {
        super(info, frame, period);
        this.noise = noise;
    }

    /// A true range [m], as the sensor shows it (REP 117).
    float shown(double range, double min, double max) {
        if (range > max) {
            return Float.POSITIVE_INFINITY;
        }
        double noisy = range + noise.next();
        if (range < min || noisy < min) {
            return Float.NEGATIVE_INFINITY;
        }
        return noisy > max ? Float.POSITIVE_INFINITY : (float) noisy;
    }

    /// Errors of ranges [m].
    ///
    /// @param deviation standard deviation [m]
    record Noise(double deviation, RandomGenerator random) {
        double next() {
            return deviation * random.nextGaussian();
        }
    }
}
