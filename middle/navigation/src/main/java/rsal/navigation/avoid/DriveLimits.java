package rsal.navigation.avoid;

/// What a differential drive may do.
///
/// @param speed [m/s]
/// @param turnRate [rad/s]
/// @param acceleration [m/s²], also of braking
/// @param turnAcceleration [rad/s²]
public record DriveLimits(double speed, double turnRate, double acceleration, double turnAcceleration) {
    public DriveLimits {
        if (!(speed > 0 && turnRate > 0 && acceleration > 0 && turnAcceleration > 0)) {
            throw new IllegalArgumentException(
                    "What a drive may do must be positive: speed '%s', turn rate '%s', accelerations (%s, %s)."
                            .formatted(speed, turnRate, acceleration, turnAcceleration));
        }
    }

    /// How fast to be at most to come to rest within a distance [m], by half of what braking can do [m/s].
    public double arriving(double distance) {
        return Math.sqrt(acceleration * distance);
    }
}
