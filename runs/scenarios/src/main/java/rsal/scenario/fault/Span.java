package rsal.scenario.fault;

import java.time.Duration;
import java.util.random.RandomGenerator;

/// A length of time that is drawn again each time, each length from the least to the most as likely.
public record Span(Duration least, Duration most) {
    public static Span of(double leastSeconds, double mostSeconds) {
        return new Span(duration(leastSeconds), duration(mostSeconds));
    }

    public static Duration duration(double seconds) {
        return Duration.ofNanos(Math.round(seconds * 1e9));
    }

    /// Takes one number of the stream, in any case.
    public Duration draw(RandomGenerator random) {
        long range = most.minus(least).toNanos();
        return least.plusNanos(Math.round(random.nextDouble() * range));
    }
}
