package rsal.engine.report;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/// How long things took, told by how many took how long.
///
/// @param counts how many took no longer than each of [#BOUNDS], but longer than the one before; and at last, how many
/// took longer than all
/// @param sum of all of them
public record Histogram(List<Long> counts, Duration sum) {
    /// From 10 µs to 5 s, three to each power of ten.
    public static final List<Duration> BOUNDS = bounds();

    public static final Histogram EMPTY = new Histogram(Collections.nCopies(BOUNDS.size() + 1, 0L), Duration.ZERO);

    public Histogram {
        counts = List.copyOf(counts);
    }

    private static List<Duration> bounds() {
        var bounds = new ArrayList<Duration>();
        for (long nanos = 10_000; nanos <= 1_000_000_000; nanos *= 10) {
            bounds.add(Duration.ofNanos(nanos));
            bounds.add(Duration.ofNanos(5 * nanos / 2));
            bounds.add(Duration.ofNanos(5 * nanos));
        }
        return List.copyOf(bounds);
    }

    /// How many there were.
    public long count() {
        return counts.stream().mapToLong(Long::longValue).sum();
    }

    /// Both together.
    Histogram plus(Histogram other) {
        var both = new ArrayList<Long>();
        for (int i = 0; i < counts.size(); i++) {
            both.add(counts.get(i) + other.counts.get(i));
        }
        return new Histogram(both, sum.plus(other.sum));
    }
}
