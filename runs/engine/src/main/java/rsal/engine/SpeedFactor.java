package rsal.engine;

import java.math.BigDecimal;

/// How fast a run is to go, as people type it: simulated over real time.
public final class SpeedFactor {
    private static final double LEAST = 0.1;
    private static final double GREATEST = 1000;
    private static final String UNLIMITED = "max";

    private SpeedFactor() {}

    /// @param typed a number from 0.1 to 1000, or `max` for +∞
    /// @throws IllegalArgumentException when it is neither
    public static double parse(String typed) {
        if (typed.equals(UNLIMITED)) {
            return Double.POSITIVE_INFINITY;
        }
        try {
            double factor = Double.parseDouble(typed);
            if (factor >= LEAST && factor <= GREATEST) {
                return factor;
            }
        } catch (NumberFormatException _) {
            // refused below, with the right words
        }
        throw new IllegalArgumentException(
                "A speed is a number from %s to %s, or max; not '%s'.".formatted(LEAST, (int) GREATEST, typed));
    }

    /// As one would type it.
    public static String format(double factor) {
        return factor == Double.POSITIVE_INFINITY
                ? UNLIMITED
                : BigDecimal.valueOf(factor).toPlainString();
    }
}
