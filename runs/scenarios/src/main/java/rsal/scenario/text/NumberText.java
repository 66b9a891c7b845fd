package rsal.scenario.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/// Numbers of results as people read them: in the terminal, on the page (`numberText` in `format.ts` has the
/// same rule) and in reports.
///
/// Whole numbers, counts above all, keep all their digits. Others are rounded to three digits, halves away from
/// 0; a whole part is never rounded. Numbers nearer to 0 than a thousandth, and those of more than 15 digits,
/// are written as `1.23e-5`.
public final class NumberText {
    private static final int DIGITS = 3;
    private static final double LEAST = 1e-3;
    private static final double GREATEST = 1e15;

    private NumberText() {}

    /// @param value −∞, +∞ and NaN are written as Java does
    public static String of(double value) {
        double size = Math.abs(value);
        if (!Double.isFinite(value)) {
            return Double.toString(value);
        }
        String digits;
        if (size < GREATEST && size == Math.rint(size)) {
            return Long.toString((long) value);
        } else if (size < LEAST || size >= GREATEST) {
            digits = scientific(size);
        } else {
            int whole = Long.toString((long) size).length();
            digits = rounded(size, Math.max(DIGITS, whole)).toPlainString();
        }
        return value < 0 ? "-" + digits : digits;
    }

    private static String scientific(double size) {
        BigDecimal rounded = rounded(size, DIGITS);
        String all = rounded.unscaledValue().toString();
        int exponent = rounded.precision() - rounded.scale() - 1;
        return "%s.%se%d".formatted(all.substring(0, 1), all.substring(1), exponent);
    }

    private static BigDecimal rounded(double size, int digits) {
        BigDecimal rounded = new BigDecimal(size).round(new MathContext(digits, RoundingMode.HALF_UP));
        int whole = rounded.precision() - rounded.scale();
        return rounded.setScale(digits - whole, RoundingMode.UNNECESSARY); // 0.25 becomes 0.250
    }
}
