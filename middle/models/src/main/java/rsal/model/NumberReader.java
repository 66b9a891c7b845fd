package rsal.model;

import java.math.BigDecimal;
import java.util.Optional;
import rsal.data.Interval;
import rsal.settings.Section;
import rsal.settings.Value;

/// Reads numbers that make sense for robots. One that does not is noted as a problem, and a harmless one taken.
final class NumberReader {
    /// No length, speed or time of a robot is beyond this.
    static final double MOST = 1000;

    static final double LEAST = 1e-6;

    private NumberReader() {}

    static double positive(Section section, String key) {
        return checked(section, key, LEAST, MOST);
    }

    static double notNegative(Section section, String key) {
        return checked(section, key, 0, MOST);
    }

    /// The number; when it can't be used, the nearest to 1 that can.
    static double checked(Section section, String key, double least, double most) {
        double harmless = Math.clamp(1, least, most);
        if (!section.has(key)) {
            section.number(key); // notes that it is missing
            return harmless;
        }
        double value = section.number(key, harmless);
        if (value >= least && value <= most) {
            return value;
        }
        section.problem(
                key,
                "'%s' must be a number from %s to %s, not '%s'."
                        .formatted(section.path(key), plain(least), plain(most), value),
                "");
        return harmless;
    }

    private static String plain(double value) {
        return BigDecimal.valueOf(value).toPlainString();
    }

    static int whole(Section section, String key, int least, int most) {
        double value = section.number(key);
        if (value >= least && value <= most && value == Math.rint(value)) {
            return (int) value;
        }
        if (section.has(key)) {
            section.problem(
                    key,
                    "'%s' must be a whole number from %d to %d, not '%s'."
                            .formatted(section.path(key), least, most, value),
                    "");
        }
        return least;
    }

    /// Both ways the same, `1.5`, or each way, `[-0.5, 1.5]`.
    ///
    /// @param oneWay whether `[0, 1.5]` will do
    static Interval bothWays(Section section, String key, boolean oneWay) {
        if (section.find(key).filter(Value.Sequence.class::isInstance).isEmpty()) {
            return Interval.around0(positive(section, key));
        }
        Optional<double[]> ends = section.numbers(key, 2);
        if (ends.isEmpty()) {
            return Interval.around0(1);
        }
        double least = ends.get()[0];
        double most = ends.get()[1];
        if (least >= -MOST && least <= (oneWay ? 0 : -LEAST) && most >= LEAST && most <= MOST) {
            return new Interval(least, most);
        }
        section.problem(
                key,
                "'%s' must be how much backward and forward, such as [-0.5, 1.5], not [%s, %s]."
                        .formatted(section.path(key), least, most),
                "");
        return Interval.around0(1);
    }
}
