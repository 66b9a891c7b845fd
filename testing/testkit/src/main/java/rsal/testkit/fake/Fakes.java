package rsal.testkit.fake;

/// What the fakes share.
final class Fakes {
    private Fakes() {}

    /// A distance as a sensor with limits reports it, after REP 117.
    static float asMeasured(double range, double min, double max) {
        if (range < min) {
            return Float.NEGATIVE_INFINITY;
        }
        return range > max ? Float.POSITIVE_INFINITY : (float) range;
    }
}
