package rsal.engine.event;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import org.jspecify.annotations.Nullable;

/// The clock of a run. Its time since the start is 0 until the robots are there: nobody knows for how long real ones
/// are looked for, and neither events, metrics nor conditions such as `time > 300` should depend on that. Any thread
/// may ask.
public final class RunClock implements InstantSource {
    private final InstantSource source;
    private volatile @Nullable Instant start;

    /// @param source what time it is, also before the start
    public RunClock(InstantSource source) {
        this.source = source;
    }

    /// A clock whose run starts now.
    public static RunClock started(InstantSource source) {
        var clock = new RunClock(source);
        clock.start();
        return clock;
    }

    /// Starts the time of the run. Once, on the run's thread.
    public void start() {
        if (start != null) {
            throw new IllegalStateException("The run has started already.");
        }
        start = source.instant();
    }

    /// What time it is for all, not since the start.
    @Override
    public Instant instant() {
        return source.instant();
    }

    /// Time since the start.
    public Duration elapsed() {
        return at(source.instant());
    }

    /// The time since the start of something that has happened.
    public Duration at(Instant when) {
        Instant from = start;
        return from == null || when.isBefore(from) ? Duration.ZERO : Duration.between(from, when);
    }
}
