package rsal.experiment.statistics;

import java.util.Arrays;
import java.util.Optional;

/// The mean of a sample and how sure it is.
///
/// @param count of the sample, at least 1
/// @param deviation of the sample, by n − 1; 0 for one value
/// @param interval of the mean it is from; empty for one value
public record Mean(int count, double value, double deviation, Optional<Interval> interval) {
    /// The interval is Student's: Student, The probable error of a mean, Biometrika 6, 1908. Right when
    /// values are independent and about normal, or many.
    ///
    /// @param values at least one
    public static Mean of(double... values) {
        if (values.length == 0) {
            throw new IllegalArgumentException("There is no mean of nothing.");
        }
        double mean = Arrays.stream(values).average().getAsDouble();
        if (values.length == 1) {
            return new Mean(1, mean, 0, Optional.empty());
        }
        int freedom = values.length - 1;
        double squares = Arrays.stream(values)
                .map(value -> (value - mean) * (value - mean))
                .sum();
        double deviation = Math.sqrt(squares / freedom);
        double margin = StudentT.critical(Interval.CONFIDENCE, freedom) * deviation / Math.sqrt(values.length);
        return new Mean(values.length, mean, deviation, Optional.of(new Interval(mean - margin, mean + margin)));
    }
}
