package rsal.time;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/// How much real time, and how much of a processor's, went into each [Phase] of a run so far. One thread at a time
/// counts, which takes a look at the clock for each phase and instant; any thread may ask. Nothing in a run may depend
/// on
/// it.
///
/// To ask for a thread's processor time takes some microseconds, as long as a phase of a small run: it is asked for
/// around
/// one of [#SAMPLED] only, which stands for all of them. There is no rhythm of phases that goes by a prime.
public final class PhaseTimes {
    private static final int SAMPLED = 31;

    private final LongSupplier clock;
    private final LongSupplier processor;
    private final Map<Phase, AtomicLong> real = sums();
    private final Map<Phase, AtomicLong> processors = sums();

    // of who counts
    private long since;
    private long processorSince;
    private int ran; // since a phase whose processor time was looked at

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
        if (ran == 0) {
            add(processors, phase, SAMPLED * (processor.getAsLong() - processorSince));
        }
        ran = (ran + 1) % SAMPLED;
        sample();
    }

    private void sample() {
        if (ran == 0) {
            processorSince = processor.getAsLong();
        }
    }

    public Duration of(Phase phase) {
        return Duration.ofNanos(sum(real, phase).get());
    }

    /// An estimate.
    public Duration processor(Phase phase) {
        return Duration.ofNanos(sum(processors, phase).get());
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
