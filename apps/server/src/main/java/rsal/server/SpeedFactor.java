package rsal.server;

import java.math.BigDecimal;

/// How fast a run is to go: simulated over real time.
final class SpeedFactor {
    private static final double SLOWEST = 0.1;
    private static final double FASTEST = 1000;

    private SpeedFactor() {}

    /// @param typed a number, or `max` for +∞
    /// @throws Refusal when it is neither, or nobody could follow
    static double of(String typed) {
        if (typed.equals("max")) {
            return Double.POSITIVE_INFINITY;
        }
        try {
            double factor = Double.parseDouble(typed);
            if (factor >= SLOWEST && factor <= FASTEST) {
                return factor;
            }
        } catch (NumberFormatException _) {
            // refused below, with the right words
        }
        throw new Refusal(
                400,
                "A speed is a number from %s to %s, or max; not (%s)."
                        .formatted(SLOWEST, (int) FASTEST, Refusal.shortened(typed)));
    }

    /// As one would type it.
    static String word(double factor) {
        return factor == Double.POSITIVE_INFINITY
                ? "max"
                : BigDecimal.valueOf(factor).toPlainString();
    }
}
