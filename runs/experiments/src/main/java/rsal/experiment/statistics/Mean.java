package rsal.experiment.statistics;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import org.apache.commons.statistics.distribution.TDistribution;

/// The mean of a sample and how sure it is.
///
/// @param count of the sample, at least 1
/// @param deviation of the sample, by n − 1; 0 for one value
/// @param interval of the mean it is from; empty for one value
public record Mean(int count, double value, double deviation, Optional<ConfidenceInterval> interval) {
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
        double margin = TDistribution.of(freedom).inverseSurvivalProbability((1 - ConfidenceInterval.CONFIDENCE) / 2)
                * deviation
                / Math.sqrt(values.length);
        return new Mean(
                values.length, mean, deviation, Optional.of(new ConfidenceInterval(mean - margin, mean + margin)));
    }

    /// How probable a mean so far from 0 or farther is when the values are from one with mean 0, by Student's t test;
    /// empty for one value.
    public OptionalDouble pValue() {
        if (count == 1) {
            return OptionalDouble.empty();
        }
        if (deviation == 0) {
            return OptionalDouble.of(value == 0 ? 1 : 0);
        }
        double t = Math.abs(value) / deviation * Math.sqrt(count);
        return OptionalDouble.of(2 * TDistribution.of(count - 1).survivalProbability(t));
    }

    /// How many standard deviations it is from 0; empty where nothing varies. Of differences within pairs this is
    /// Cohen's d_z: D. Lakens, Calculating and reporting effect sizes, Frontiers in Psychology 4:863, 2013,
    /// equation 7.
    public OptionalDouble standardized() {
        return deviation == 0 ? OptionalDouble.empty() : OptionalDouble.of(value / deviation);
    }
}
