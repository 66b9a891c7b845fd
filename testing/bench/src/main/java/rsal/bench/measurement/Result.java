package rsal.bench.measurement;

import java.util.Arrays;

/// A number that was measured.
///
/// @param name dotted (`sim.laser180.1000.core1.rtf`)
/// @param value the median; the mean where that is said
/// @param least of all repeats
/// @param most of all repeats
/// @param better `more` or `less`
public record Result(String name, double value, double least, double most, String unit, String better) {

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
        return new Result(name, median, sorted[0], sorted[last], unit, better);
    }

    /// The same with another value.
    public Result withValue(double other) {
        return new Result(name, other, least, most, unit, better);
    }

    /// Something else of the same kind, known once.
    public Result at(String otherName, double other) {
        return new Result(otherName, other, other, other, unit, better);
    }
}
