package rsal.engine.metric;

import java.util.Arrays;
import java.util.OptionalDouble;
import rsal.scenario.condition.MetricExpression.Aggregate;
import rsal.scenario.condition.MetricExpression.Function;
import rsal.scenario.condition.MetricExpression.Quantile;

/// Samples of a signal, each with its time [s]. Least, greatest and means count all of them; percentiles count
/// every one up to a number, then every second, every fourth…, so that memory stays bounded.
final class Samples {
    private static final int MOST = 1 << 16;
    private static final double ROUNDING = 1e-9; // that 0.07 * 100 is not above 7

    private double[] kept = new double[64];
    private int size;
    private long stride = 1;
    private long count;
    private double sum;
    private double squares;
    private double min = Double.POSITIVE_INFINITY;
    private double max = Double.NEGATIVE_INFINITY;
    private double newest = Double.NaN;
    private double newestAt = Double.NEGATIVE_INFINITY; // s
    private double weighted; // sum of samples, each times how long it was the newest [s]
    private double weights; // s

    /// @param at not before the last one [s]
    void add(double at, double sample) {
        weighted = weighted(at);
        weights = weights(at);
        newest = sample;
        newestAt = at;
        if (count++ % stride == 0) {
            keep(sample);
        }
        sum += sample;
        squares += sample * sample;
        min = Math.min(min, sample);
        max = Math.max(max, sample);
    }

    /// All samples of several together, each of which counts as much as any other.
    ///
    /// @param until to when the newest of each counts [s]
    static Samples together(Iterable<Samples> several, double until) {
        var all = new Samples();
        double newestAt = Double.NEGATIVE_INFINITY;
        for (Samples one : several) {
            all.addAll(one, until);
            if (one.newestAt > newestAt) {
                newestAt = one.newestAt;
                all.newest = one.newest;
            }
        }
        all.newestAt = until;
        return all;
    }

    /// Those of both are thinned out alike.
    private void addAll(Samples other, double until) {
        while (stride < other.stride) {
            thinOut();
        }
        for (int i = 0; i < other.size; i += (int) (stride / other.stride)) {
            keep(other.kept[i]); // may thin out
        }
        count += other.count;
        sum += other.sum;
        squares += other.squares;
        min = Math.min(min, other.min);
        max = Math.max(max, other.max);
        weighted += other.weighted(until);
        weights += other.weights(until);
    }

    private double weighted(double until) {
        return count == 0 ? 0 : weighted + newest * (until - newestAt);
    }

    private double weights(double until) {
        return count == 0 ? 0 : weights + until - newestAt;
    }

    private void thinOut() {
        size = Math.ceilDiv(size, 2);
        stride *= 2;
        for (int i = 0; i < size; i++) {
            kept[i] = kept[2 * i];
        }
    }

    private void keep(double sample) {
        if (size == MOST) {
            thinOut();
        }
        if (size == kept.length) {
            kept = Arrays.copyOf(kept, 2 * size);
        }
        kept[size++] = sample;
    }

    /// Empty without samples.
    ///
    /// @param until to when the newest counts [s]
    OptionalDouble value(Aggregate aggregate, double until) {
        if (count == 0) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(
                switch (aggregate) {
                    case Quantile(var share) -> quantile(share);
                    case Function function -> value(function, until);
                });
    }

    private double value(Function function, double until) {
        return switch (function) {
            case LAST -> newest;
            case MIN -> min;
            case MAX -> max;
            case MEAN -> sum / count;
            case TIME_WEIGHTED_MEAN -> weights(until) > 0 ? weighted(until) / weights(until) : newest;
            case RMS -> Math.sqrt(squares / count);
            case P50 -> quantile(0.50);
            case P95 -> quantile(0.95);
            case P99 -> quantile(0.99);
        };
    }

    /// Nearest rank.
    private double quantile(double share) {
        double[] sorted = Arrays.copyOf(kept, size);
        Arrays.sort(sorted);
        return sorted[Math.max(0, (int) Math.ceil(share * size - ROUNDING) - 1)];
    }
}
