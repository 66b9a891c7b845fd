package rsal.sim.world;

/// Angles that are a little wrong but fast, to find out which rays are worth a closer look.
final class RoughAngles {
    /// How wrong [#atan2] is at most [rad].
    static final double ERROR = 0.005;

    private RoughAngles() {}

    /// As [Math#atan2], by Rajan, Wang, Inkol and Joyal, Efficient Approximations for the Arctangent Function, IEEE
    /// Signal Processing Magazine 23 (2006), equation 7, whose error is at most 0.0038 rad.
    static double atan2(double y, double x) {
        double across = Math.abs(x);
        double up = Math.abs(y);
        double least = Math.min(across, up);
        double most = Math.max(across, up);
        double slope = most == 0 ? 0 : least / most;
        double angle = slope * (Math.PI / 4 + 0.273 * (1 - slope));
        angle = up > across ? Math.PI / 2 - angle : angle;
        angle = x < 0 ? Math.PI - angle : angle;
        return y < 0 ? -angle : angle;
    }

    /// Not less than [Math#asin], from 0 to 1: (asin q − q)/q³ grows with q and is π/2 − 1 at its end.
    static double asinAtLeast(double q) {
        return q + (Math.PI / 2 - 1) * q * q * q;
    }
}
