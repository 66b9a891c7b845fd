package rsal.agent.protocol;

import java.time.Duration;

/// How long the initiator of a conversation waits for a partner.
///
/// @param repeat after how long it says again what was not answered, or asks again one that works on something; a
/// quarter of it once two of these brought nothing
/// @param silence after how long without a sign a partner counts as silent; at least as long as `repeat`
public record RetryPolicy(Duration repeat, Duration silence) {
    /// Bears the loss of several messages in a row, and notices within five seconds that somebody is gone.
    public static final RetryPolicy DEFAULT = new RetryPolicy(Duration.ofSeconds(1), Duration.ofSeconds(5));

    public RetryPolicy {
        if (!repeat.isPositive() || silence.compareTo(repeat) < 0) {
            throw new IllegalArgumentException(
                    "A retry policy needs 0 < repeat <= silence, not '%s' and '%s'.".formatted(repeat, silence));
        }
    }
}
