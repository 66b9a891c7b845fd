package rsal.bench.measurement;

import java.util.Arrays;
import java.util.List;

/// How sure a mean is: `<name>`, the mean, comes with `<name>.low` and `<name>.high`, ends of its 95 % confidence
/// interval (Student's t, two-sided). There is none of a single value.
public final class Confidence {
    /// 97.5 % quantiles of Student's t distribution for 1, 2, … degrees of freedom.
    private static final double[] STUDENT = {
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120,
        2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042
    };

    private static final double NORMAL = 1.960;

    private Confidence() {}

    public static List<String> names(String name) {
        return List.of(name, name + ".low", name + ".high");
    }

    public static List<Result> more(String name, String unit, double... values) {
        return of(Result.more(name, unit, values), values);
    }

    public static List<Result> less(String name, String unit, double... values) {
        return of(Result.less(name, unit, values), values);
    }

    private static List<Result> of(Result result, double... values) {
        return interval(result.withValue(Arrays.stream(values).average().orElseThrow()), margin(values));
    }

    /// @param margin half the width of the interval around the value; NaN when it is not known
    static List<Result> interval(Result middle, double margin) {
        if (Double.isNaN(margin)) {
            return List.of(middle);
        }
        List<String> names = names(middle.name());
        return List.of(
                middle,
                middle.at(names.get(1), middle.value() - margin),
                middle.at(names.get(2), middle.value() + margin));
    }

    /// Half the width of the 95 % confidence interval of the mean, two-sided, of values that are about normally
    /// distributed; NaN for fewer than two. Beyond 31 values the quantile is approximated as by Cornish and Fisher
    /// in the first order, right to 0.1 %.
    static double margin(double... values) {
        int freedom = values.length - 1;
        if (freedom < 1) {
            return Double.NaN;
        }
        double mean = Arrays.stream(values).average().orElseThrow();
        double squares = Arrays.stream(values)
                .map(value -> (value - mean) * (value - mean))
                .sum();
        double t = freedom <= STUDENT.length
                ? STUDENT[freedom - 1]
                : NORMAL + (NORMAL * NORMAL * NORMAL + NORMAL) / (4 * freedom);
        return t * Math.sqrt(squares / freedom / values.length);
    }
}
