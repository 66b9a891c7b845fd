package rsal.experiment.report;

import java.util.Locale;
import rsal.experiment.statistics.ConfidenceInterval;
import rsal.scenario.text.NumberText;

/// Numbers as people read them.
public final class NumberFormats {
    private NumberFormats() {}

    /// As [NumberText] has it, with a minus sign in place of a hyphen.
    public static String of(double value) {
        return NumberText.of(value).replaceFirst("^-", "−");
    }

    /// How far it may be off beside it, both to the digit that the error leaves sure: `0.0390 ± 0.0006`. That is two
    /// digits of an error that begins with a one or a two, else one.
    public static String withError(double value, double error) {
        if (!(error > 0) || !Double.isFinite(error)) {
            return of(value) + " ± " + of(error);
        }
        double largest = Math.max(Math.abs(value), error);
        int power = largest >= 1e6 || largest < 1e-3 ? (int) Math.floor(Math.log10(largest)) : 0;
        double unit = Math.pow(10, power);
        int first = (int) Math.floor(Math.log10(error / unit));
        int digits = Math.clamp(error / unit / Math.pow(10, first) < 2.95 ? 1 - first : -first, 0, 9);
        String both = fixed(value / unit, digits) + " ± " + fixed(error / unit, digits);
        return power == 0 ? both : "(%s)e%d".formatted(both, power);
    }

    private static String fixed(double value, int digits) {
        return withMinus(value, String.format(Locale.ROOT, "%." + digits + "f", Math.abs(value)));
    }

    /// Unless nothing is left of it in so many digits.
    private static String withMinus(double value, String digits) {
        return value < 0 && !digits.matches("[0.]*") ? "−" + digits : digits;
    }

    /// With its sign.
    static String signed(double value) {
        return value > 0 ? "+" + of(value) : of(value);
    }

    static String of(ConfidenceInterval interval) {
        return of(interval.low()) + " to " + of(interval.high());
    }

    static String signed(ConfidenceInterval interval) {
        return signed(interval.low()) + " to " + signed(interval.high());
    }

    static String probability(double p) {
        return p < 0.001 ? "< 0.001" : String.format(Locale.ROOT, "%.3f", p);
    }

    static String percent(double share) {
        return String.format(Locale.ROOT, "%.0f %%", 100 * share);
    }

    /// For programs: as exactly as it is known.
    static String exact(double value) {
        return Double.toString(value);
    }
}
