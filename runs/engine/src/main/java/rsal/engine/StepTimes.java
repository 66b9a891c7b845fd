package rsal.engine;

import java.time.Duration;
import java.util.ArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import rsal.engine.report.Histogram;

/// How long steps took so far. One thread counts, which allocates nothing; any thread may ask.
final class StepTimes {
    private static final long[] BOUNDS =
            Histogram.BOUNDS.stream().mapToLong(Duration::toNanos).toArray();

    private final AtomicLongArray counts = new AtomicLongArray(BOUNDS.length + 1);
    private final AtomicLong sum = new AtomicLong(); // [ns]

    void took(long nanos) {
        int i = 0;
        while (i < BOUNDS.length && nanos > BOUNDS[i]) {
            i++;
        }
        counts.setRelease(i, counts.getPlain(i) + 1);
        sum.setRelease(sum.getPlain() + nanos);
    }

    Histogram soFar() {
        var all = new ArrayList<Long>();
        for (int i = 0; i < counts.length(); i++) {
            all.add(counts.get(i));
        }
        return new Histogram(all, Duration.ofNanos(sum.get()));
    }
}
