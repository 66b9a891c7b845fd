package rsal.time;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/// How much real time, and how much of a processor's, went into each [Phase] of a run so far. One thread at a time
/// counts, which takes a look at the clock for each phase and instant; any thread may ask. Nothing in a run may
/// depend on it.
///
/// To ask for a thread's processor time takes some microseconds, as long as a phase of a small run: it is asked for
/// around one phase of 31 on average, drawn at random so that no rhythm of phases hides from it, which stands for the
/// others.
public final class PhaseTimes {
    private static final int SAMPLED = 31; // one of so many, on average

    private final LongSupplier clock;
    private final LongSupplier processor;
    private final Map<Phase, AtomicLong> real = sums();
    private final Map<Phase, AtomicLong> processors = sums();

    // of who counts
    private long since;
    private long processorSince;
    private int left = 1; // phases until one whose processor time is looked at has run
    private int random = 1; // never 0; of its own, as nothing in a run may depend on it

    /// @param clock real time [ns]
    /// @param processor time of the processor that the thread which asks has taken [ns]
    public PhaseTimes(LongSupplier clock, LongSupplier processor) {
        this.clock = clock;
        this.processor = processor;
    }

    /// For nobody who wants to know.
    static PhaseTimes none() {
        return new PhaseTimes(() -> 0, () -> 0);
    }

    /// What comes now counts, what was before does not.
    void begin() {
        since = clock.getAsLong();
        sample();
    }

    /// All since the beginning, or the phase before, was this phase's.
    void ran(Phase phase) {
        long now = clock.getAsLong();
        add(real, phase, now - since);
        since = now;
        if (left == 1) {
            add(processors, phase, SAMPLED * (processor.getAsLong() - processorSince));
            left = 2 + drawn(2 * SAMPLED - 2);
        }
        left--;
        sample();
    }

    private void sample() {
        if (left == 1) {
            processorSince = processor.getAsLong();
        }
    }

    /// From 0 to less than a bound: G. Marsaglia, Xorshift RNGs, Journal of Statistical Software 8 (2003).
    private int drawn(int bound) {
        random ^= random << 13;
        random ^= random >>> 17;
        random ^= random << 5;
        return Integer.remainderUnsigned(random, bound);
    }

    public Duration of(Phase phase) {
        return Duration.ofNanos(sum(real, phase).get());
    }

    /// An estimate.
    public Duration processor(Phase phase) {
        return Duration.ofNanos(sum(processors, phase).get());
    }

    /// Each phase's, as [#of].
    public Map<Phase, Duration> all() {
        return byPhase(real);
    }

    /// Each phase's, as [#processor].
    public Map<Phase, Duration> allOfProcessor() {
        return byPhase(processors);
    }

    private static Map<Phase, Duration> byPhase(Map<Phase, AtomicLong> sums) {
        var all = new EnumMap<Phase, Duration>(Phase.class);
        sums.forEach((phase, sum) -> all.put(phase, Duration.ofNanos(sum.get())));
        return all;
    }

    private static void add(Map<Phase, AtomicLong> sums, Phase phase, long nanos) {
        AtomicLong sum = sum(sums, phase);
        sum.setRelease(sum.getPlain() + nanos); // nobody else writes
    }

    private static AtomicLong sum(Map<Phase, AtomicLong> sums, Phase phase) {
        return Objects.requireNonNull(sums.get(phase)); // each has one
    }

    private static Map<Phase, AtomicLong> sums() {
        var sums = new EnumMap<Phase, AtomicLong>(Phase.class);
        for (Phase phase : Phase.values()) {
            sums.put(phase, new AtomicLong());
        }
        return sums;
    }
}
