package rsal.bench.measurement;

import java.util.Arrays;
import java.util.Optional;

/// A number that was measured.
///
/// @param name dotted (`sim.laser180.1000.core1.rtf`)
/// @param value the median; the mean where that is said
/// @param least of all repeats
/// @param most of all repeats
/// @param better `more` or `less`
/// @param goal which the value is to reach, where there is one
public record Result(
        String name, double value, double least, double most, String unit, String better, Optional<Double> goal) {

    public static Result more(String name, String unit, double... values) {
        return of(name, unit, "more", values);
    }

    public static Result less(String name, String unit, double... values) {
        return of(name, unit, "less", values);
    }

    private static Result of(String name, String unit, String better, double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int last = sorted.length - 1;
        double median = (sorted[last / 2] + sorted[(last + 1) / 2]) / 2;
        return new Result(name, median, sorted[0], sorted[last], unit, better, Optional.empty());
    }

    /// The same with another value.
    public Result withValue(double other) {
        return new Result(name, other, least, most, unit, better, goal);
    }

    /// Something else of the same kind, known once.
    public Result at(String otherName, double other) {
        return new Result(otherName, other, other, other, unit, better, Optional.empty());
    }

    /// The same with something to reach: the most that is good where less is better, the least where more is.
    public Result toReach(double figure) {
        return new Result(name, value, least, most, unit, better, Optional.of(figure));
    }
}
