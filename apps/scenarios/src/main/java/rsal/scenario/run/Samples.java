package rsal.scenario.run;

import java.util.Arrays;
import java.util.OptionalDouble;
import rsal.scenario.condition.Measure;

/// Samples of a signal. Least, greatest and means count all of them; percentiles count every one up to a number,
/// then every second, every fourth…, so that memory stays bounded.
final class Samples {
    private static final int MOST = 1 << 16;

    private double[] kept = new double[64];
    private int size;
    private long stride = 1;
    private long count;
    private double sum;
    private double squares;
    private double min = Double.POSITIVE_INFINITY;
    private double max = Double.NEGATIVE_INFINITY;

    void add(double sample) {
        if (count++ % stride == 0) {
            keep(sample);
        }
        sum += sample;
        squares += sample * sample;
        min = Math.min(min, sample);
        max = Math.max(max, sample);
    }

    /// Those of both are thinned out alike, so that each sample counts as much as any other.
    void addAll(Samples other) {
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
    OptionalDouble value(Measure.Function function) {
        if (count == 0) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(
                switch (function) {
                    case MIN -> min;
                    case MAX -> max;
                    case MEAN -> sum / count;
                    case RMS -> Math.sqrt(squares / count);
                    case P50 -> percentile(50);
                    case P95 -> percentile(95);
                    case P99 -> percentile(99);
                });
    }

    /// Nearest rank.
    private double percentile(int percent) {
        double[] sorted = Arrays.copyOf(kept, size);
        Arrays.sort(sorted);
        return sorted[Math.ceilDiv(percent * size, 100) - 1];
    }
}
