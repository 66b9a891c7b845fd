package rsal.data;

/// Rays that leave one place at equal angles, counter-clockwise.
///
/// @param first direction of the first ray in the sensor's frame [rad]
/// @param increment angle between rays [rad]; not negative, all of them together ten turns at most
public record Fan(Pose2d baseFromSensor, double first, double increment, int count) {
    private static final double RAYS_APART = Math.toRadians(5);
    private static final double NARROW = Math.toRadians(1);
    private static final double WIDEST = 20 * Math.PI; // of what is not a sensor any more

    public Fan {
        if (!(Double.isFinite(first) && increment >= 0 && count >= 1 && (count - 1) * increment < WIDEST)) {
            throw new IllegalArgumentException("A fan can't have %d rays that are %s rad apart from %s rad on."
                    .formatted(count, increment, first));
        }
    }

    /// A cone along the sensor's x axis, as rays at most 5° apart; one that is no wider than 1° is a ray.
    ///
    /// @param width full opening angle [rad]
    public static Fan cone(Pose2d baseFromSensor, double width) {
        if (!(width < WIDEST)) {
            throw new IllegalArgumentException("A cone can't have the width (%s rad).".formatted(width));
        }
        if (width <= NARROW) {
            return new Fan(baseFromSensor, 0, width, 1);
        }
        int gaps = (int) Math.ceil(width / RAYS_APART);
        return new Fan(baseFromSensor, -width / 2, width / gaps, gaps + 1);
    }
}
