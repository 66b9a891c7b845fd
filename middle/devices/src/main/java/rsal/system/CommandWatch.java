package rsal.system;

import java.time.Duration;
import java.util.Optional;

/// When the last command for a device came, and whether that is too long ago. Bridges and people who drive by
/// hand have one each. Times are of any clock that only goes forward [ns].
///
/// One thread notes commands, any thread may ask.
public final class CommandWatch {
    private final Optional<Duration> limit;
    private volatile long last;

    /// @param limit for how long a command holds; empty for ever
    /// @param since the first command is taken to have come then [ns]
    public CommandWatch(Optional<Duration> limit, long since) {
        this.limit = limit;
        this.last = since;
    }

    /// A command came from a client. One that is told late counts from when it came.
    public void heard(long at) {
        last = at - last > 0 ? at : last;
    }

    /// For how long no command came.
    public Duration silence(long now) {
        return Duration.ofNanos(now - last);
    }

    /// Whether no command came for too long, or rather will not have by halfway to the next look: so the device
    /// is stopped at most half a period after the limit, and at most half a period before.
    ///
    /// @param period between two looks
    public boolean isSilent(long now, Duration period) {
        return limit.filter(most -> silence(now).compareTo(most.minus(period.dividedBy(2))) > 0)
                .isPresent();
    }
}
