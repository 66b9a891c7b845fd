package rsal.time;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/// How much real time went into each [Phase] of a run so far. One thread at a time counts, which takes a look at the
/// clock for each phase and instant; any thread may ask. Nothing in a run may depend on it.
public final class PhaseTimes {
    private final LongSupplier clock;
    private final Map<Phase, AtomicLong> nanos = new EnumMap<>(Phase.class);
    private long since; // of who counts

    /// @param clock real time [ns]; `() -> 0` when nobody wants to know
    public PhaseTimes(LongSupplier clock) {
        this.clock = clock;
        for (Phase phase : Phase.values()) {
            nanos.put(phase, new AtomicLong());
        }
    }

    /// What comes now counts, what was before does not.
    void begin() {
        since = clock.getAsLong();
    }

    /// All since the beginning, or the phase before, was this phase's.
    void ran(Phase phase) {
        long now = clock.getAsLong();
        AtomicLong sum = sum(phase);
        sum.setRelease(sum.getPlain() + now - since); // nobody else writes
        since = now;
    }

    public Duration of(Phase phase) {
        return Duration.ofNanos(sum(phase).get());
    }

    private AtomicLong sum(Phase phase) {
        return Objects.requireNonNull(nanos.get(phase)); // each has one
    }
}
