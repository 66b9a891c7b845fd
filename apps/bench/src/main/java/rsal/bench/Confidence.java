package rsal.bench;

import java.util.Arrays;

/// How sure a mean is.
final class Confidence {
    /// 97.5 % quantiles of Student's t distribution for 1, 2, … degrees of freedom.
    private static final double[] STUDENT = {
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120,
        2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042
    };

    private static final double NORMAL = 1.960;

    private Confidence() {}

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
