package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;

/// When readings were taken, by our own clock. A server stamps them by one that began elsewhere and may be simulated.
/// What was soonest on its way in the last seconds tells how far the clocks are apart, and so how long the others have
/// been on their way; at most 200 ms, as simulated time may go slower than ours. May be used on any thread.
final class ServerClock {
    private static final Duration WINDOW = Duration.ofSeconds(2);
    private static final Duration LONGEST_DELAY = Duration.ofMillis(200);

    private Instant windowEnds = Instant.MIN;
    private Duration least = Duration.ZERO; // of this window, that a stamp is behind its arrival
    private Duration leastBefore = Duration.ZERO; // of the window before it

    /// @param stamp of the server's clock [s]; what is not a time counts as now
    synchronized Instant taken(double stamp, Instant arrival) {
        if (!(Math.abs(stamp) < 1e11)) {
            return arrival;
        }
        long seconds = (long) Math.floor(stamp);
        var stamped = Instant.ofEpochSecond(seconds, Math.round((stamp - seconds) * 1e9));
        Duration behind = Duration.between(stamped, arrival);
        if (arrival.isAfter(windowEnds)) {
            leastBefore = windowEnds.equals(Instant.MIN) ? behind : least;
            least = behind;
            windowEnds = arrival.plus(WINDOW);
        } else if (behind.compareTo(least) < 0) {
            least = behind;
        }
        Duration delay = behind.minus(least.compareTo(leastBefore) < 0 ? least : leastBefore);
        if (delay.isNegative()) {
            return arrival;
        }
        return arrival.minus(delay.compareTo(LONGEST_DELAY) < 0 ? delay : LONGEST_DELAY)
                .truncatedTo(ChronoUnit.MICROS);
    }
}
