package rsal.system;

import java.time.Duration;
import java.util.Optional;
import java.util.function.LongSupplier;

/// For how long what a client commanded holds when no further command comes from it, by the clock on the wall:
/// a client that hangs, or whose connection is silent, must not go on driving robots. Every bridge that repeats
/// commands to a device asks a [CommandWatch] before. `rsal.testkit.contract.CommandTimeoutContract` says what
/// each owes.
///
/// @param limit empty for clients that command once, and mean it until they say otherwise
/// @param nanos the clock; any thread asks it [ns]
public record CommandTimeout(Optional<Duration> limit, LongSupplier nanos) {
    /// As long as bases take commands for.
    public static final Duration USUAL = Duration.ofMillis(500);

    /// Commands hold for ever.
    public static CommandTimeout none() {
        return new CommandTimeout(Optional.empty(), () -> 0);
    }

    /// What the clock says [ns].
    public long now() {
        return nanos.getAsLong();
    }

    /// Of one device, from now on.
    public CommandWatch watch() {
        return new CommandWatch(limit, now());
    }
}
