package rsal.stage;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.Optional;
import rsal.settings.Value;

/// What a file's lengths and angles are in.
///
/// @param length of one unit [m]
/// @param angle of one unit [rad]
record Units(double length, double angle) {
    static final Units DEFAULT = new Units(1, Math.toRadians(1));

    /// What one number of a property is, and so how it is scaled.
    enum Kind {
        LENGTH,
        ANGLE,
        /// As it is.
        NUMBER
    }

    double scale(Kind kind) {
        return switch (kind) {
            case LENGTH -> length;
            case ANGLE -> angle;
            case NUMBER -> 1;
        };
    }

    /// How messages call the unit; empty when there is none.
    String name(Kind kind) {
        return switch (kind) {
            case LENGTH -> length == 1 ? "m" : length == 0.01 ? "cm" : "mm";
            case ANGLE -> angle == 1 ? "rad" : "degrees";
            case NUMBER -> "";
        };
    }

    /// A number as it would be written in a file with these units.
    ///
    /// @param number in m or degrees
    String written(Kind kind, double number) {
        return switch (kind) {
            case LENGTH -> plain(number / length);
            case ANGLE -> plain(angle == 1 ? Math.toRadians(number) : number);
            case NUMBER -> plain(number);
        };
    }

    /// To six digits, without those that say nothing.
    static String plain(double number) {
        return new BigDecimal(number)
                .round(new MathContext(6))
                .stripTrailingZeros()
                .toPlainString();
    }

    /// A number as Stage would take it: a tuple's first value counts, and a text that is a number.
    ///
    /// @return NaN when it is none
    static double number(Value value) {
        return switch (value) {
            case Value.Sequence tuple ->
                tuple.items().isEmpty() ? Double.NaN : number(tuple.items().getFirst());
            case Value.Scalar scalar when scalar.value() instanceof Number number -> number.doubleValue();
            case Value.Scalar scalar -> parse(scalar.value().toString());
            case Value.Mapping _ -> Double.NaN;
        };
    }

    /// A text as Stage would take it: a tuple's first value counts, and a number as it is written.
    static String text(Value value) {
        return switch (value) {
            case Value.Sequence tuple ->
                tuple.items().isEmpty() ? "" : text(tuple.items().getFirst());
            case Value.Scalar scalar -> scalar.value().toString();
            case Value.Mapping _ -> "";
        };
    }

    /// What a word may have been meant to be that stands where a number should; empty when it is neither yes nor no.
    static Optional<String> flag(String word) {
        return switch (word.toLowerCase(Locale.ROOT)) {
            case "true", "yes", "on" -> Optional.of("Maybe 1, for yes?");
            case "false", "no", "off" -> Optional.of("Maybe 0, for no?");
            default -> Optional.empty();
        };
    }

    private static double parse(String text) {
        try {
            return Double.parseDouble(text.strip());
        } catch (NumberFormatException _) {
            return Double.NaN;
        }
    }
}
