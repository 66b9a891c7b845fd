package rsal.system;

import java.time.Duration;
import java.util.Optional;
import java.util.function.LongSupplier;

/// For how long what a client commanded holds when no further command comes from it, by the clock on the wall: a client
/// that hangs, or whose connection is silent, must not go on driving robots. Every bridge that repeats commands to a
/// device asks a [Watch] of it before.
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

    /// Of one device.
    public Watch watch() {
        return new Watch();
    }

    /// When the last command for a device came. Safe for any thread.
    public final class Watch {
        private volatile long last = nanos.getAsLong();

        private Watch() {}

        /// A command came from a client.
        public void heard() {
            last = nanos.getAsLong();
        }

        /// Whether no command came for too long, or would not have until the next look.
        ///
        /// @param period between two looks
        public boolean isSilent(Duration period) {
            return limit.filter(most -> nanos.getAsLong() - last
                            > most.minus(period.dividedBy(2)).toNanos())
                    .isPresent();
        }
    }
}
