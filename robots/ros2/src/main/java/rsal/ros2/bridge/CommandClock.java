package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.function.LongSupplier;
import rsal.system.Bridge.Pace;

/// The time by which commands get old: that on the wall, or the run's own while programs that follow it hold it back.
/// Such a run is as slow as they are, so real time would make their commands old before they could send others. Only
/// goes forward. Of the run's thread.
final class CommandClock {
    private final LongSupplier real; // [ns]
    private final InstantSource run;
    private boolean isOfRun;
    private long before; // what had passed when it changed over [ns]
    private long since; // what the one that counts said then [ns]

    /// @param real time [ns]
    CommandClock(LongSupplier real, InstantSource run) {
        this.real = real;
        this.run = run;
        since = real.getAsLong();
        before = since;
    }

    private long source() {
        return isOfRun ? Duration.between(Instant.EPOCH, run.instant()).toNanos() : real.getAsLong();
    }

    /// [ns]
    long now() {
        return before + source() - since;
    }

    /// Whether the run is held back from now on.
    void follow(Pace pace) {
        boolean isHeld = pace == Pace.FOLLOWED || pace == Pace.AWAITED;
        if (isHeld != isOfRun) {
            before = now();
            isOfRun = isHeld;
            since = source();
        }
    }
}
