package rsal.data;

/// Arithmetic on angles [rad], right across ±π.
public final class Angles {
    private static final double TURN = 2 * Math.PI;

    private Angles() {}

    /// The same direction in [-π, π). NaN and infinities become NaN.
    public static double wrap(double angle) {
        if (angle >= -Math.PI && angle < Math.PI) {
            return angle;
        }
        if (Math.abs(angle) < TURN) { // nearly always; exact, too: P. Sterbenz, Floating-Point Computation (1974), 4.3
            return angle < 0 ? angle + TURN : angle - TURN;
        }
        double wrapped = Math.IEEEremainder(angle, TURN); // exact, however far the angle is
        return wrapped == Math.PI ? -Math.PI : wrapped;
    }

    /// The smallest turn from one direction to another, in [-π, π); positive is counter-clockwise.
    public static double difference(double from, double to) {
        double turn = to - from;
        return wrap(Double.isInfinite(turn) ? wrap(to) - wrap(from) : turn); // too far apart to be subtracted
    }
}
