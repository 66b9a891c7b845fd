package rsal.experiment.statistics;

import java.util.Arrays;
import java.util.List;

/// A sample as a box plot shows it: J. Tukey, Exploratory Data Analysis, 1977. Quartiles are interpolated as
/// R and NumPy do: R. Hyndman, Y. Fan, Sample quantiles in statistical packages, The American Statistician
/// 50(4), 1996, definition 7.
///
/// @param low where the lower whisker ends: the least value not more than 1.5 boxes below the box
/// @param high where the upper whisker ends
/// @param outside values beyond the whiskers, ascending
public record BoxPlot(
        double least,
        double low,
        double first,
        double median,
        double third,
        double high,
        double most,
        List<Double> outside) {
    private static final double REACH = 1.5; // of whiskers, in boxes

    public BoxPlot {
        outside = List.copyOf(outside);
    }

    /// @param values at least one
    public static BoxPlot of(double... values) {
        if (values.length == 0) {
            throw new IllegalArgumentException("There is no box plot of nothing.");
        }
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        double first = quantile(sorted, 0.25);
        double third = quantile(sorted, 0.75);
        double reach = REACH * (third - first);
        double[] within = Arrays.stream(sorted)
                .filter(value -> value >= first - reach && value <= third + reach)
                .toArray();
        return new BoxPlot(
                sorted[0],
                Math.min(within[0], first),
                first,
                quantile(sorted, 0.5),
                third,
                Math.max(within[within.length - 1], third),
                sorted[sorted.length - 1],
                Arrays.stream(sorted)
                        .filter(value -> value < first - reach || value > third + reach)
                        .boxed()
                        .toList());
    }

    /// @param sorted ascending, at least one
    static double quantile(double[] sorted, double share) {
        double place = share * (sorted.length - 1);
        int below = (int) place;
        if (below == sorted.length - 1) {
            return sorted[below];
        }
        return sorted[below] + (place - below) * (sorted[below + 1] - sorted[below]);
    }
}
