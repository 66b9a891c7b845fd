package rsal.experiment.report;

import java.util.Locale;
import rsal.experiment.statistics.Interval;

/// Numbers as people read them.
public final class Numbers {
    private Numbers() {}

    /// With about three digits that say something.
    public static String of(double value) {
        double size = Math.abs(value);
        String digits;
        if (value == Math.rint(value) && size < 1e6) {
            digits = Long.toString((long) size);
        } else if (size >= 1e6 || size < 1e-3) {
            digits = String.format(Locale.ROOT, "%.2e", size);
        } else {
            digits = String.format(
                    Locale.ROOT, size >= 1000 ? "%.0f" : size >= 100 ? "%.1f" : size >= 1 ? "%.2f" : "%.3f", size);
        }
        return value < 0 && !digits.matches("[0.]*") ? "−" + digits : digits;
    }

    /// With its sign.
    static String signed(double value) {
        return value > 0 ? "+" + of(value) : of(value);
    }

    static String of(Interval interval) {
        return of(interval.low()) + " to " + of(interval.high());
    }

    static String signed(Interval interval) {
        return signed(interval.low()) + " to " + signed(interval.high());
    }

    static String percent(double share) {
        return String.format(Locale.ROOT, "%.0f %%", 100 * share);
    }

    /// For programs: as exactly as it is known.
    static String exact(double value) {
        return Double.toString(value);
    }
}
