package rsal.time;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/// A time that another program drives, such as a simulator which is not ours: it goes as fast as that program says, and
/// stands while that says nothing. It begins with the first time that is set, before which it is the epoch, and never
/// goes back. Any thread may set it, and ask.
public final class DrivenTime implements TimeSource {
    /// Steps back by at most that are messages that overtook each other.
    private static final Duration JITTER = Duration.ofSeconds(1);

    private final Consumer<String> onReset;
    private final List<Runnable> listeners = new ArrayList<>(); // added before it is set
    private final List<Consumer<? super Instant>> followers = new ArrayList<>(); // also
    private volatile @Nullable Span span;

    private record Span(Instant first, Instant newest) {}

    /// @param onReset gets a sentence for people each time that it should go back, on the thread that sets it
    public DrivenTime(Consumer<String> onReset) {
        this.onReset = onReset;
    }

    /// Runs something after each change, on the thread that sets the time. To be called before that.
    void onChange(Runnable listener) {
        listeners.add(listener);
    }

    /// Hears of each time, or of the newest of several, when all that is due by then is done: also what was handed in
    /// before, and the [work][Scheduler#compute] of other threads. To be called before the time is set.
    ///
    /// @param listener called on the scheduler's thread
    public void onReached(Consumer<? super Instant> listener) {
        followers.add(listener);
    }

    /// All is done that was due by then.
    void reached(Instant time) {
        followers.forEach(each -> each.accept(time));
    }

    /// What time it is from now on, unless that is before the newest: this changes nothing, and is a reset if it is by
    /// more than a second.
    public void set(Instant now) {
        Instant before;
        boolean isFirst;
        synchronized (this) {
            Span known = span;
            isFirst = known == null;
            before = known == null ? now : known.newest;
            if (!now.isBefore(before)) {
                span = new Span(known == null ? now : known.first, now);
            }
        }
        if (now.isBefore(before.minus(JITTER))) {
            onReset.accept(
                    "The time of the simulator, which the run follows, went back from %.1f s to %.1f s. Start the run again after a reset."
                            .formatted(seconds(before), seconds(now)));
        } else if (isFirst || now.isAfter(before)) {
            listeners.forEach(Runnable::run);
        }
    }

    private static double seconds(Instant time) {
        return Duration.between(Instant.EPOCH, time).toMillis() / 1e3;
    }

    @Override
    public Instant instant() {
        Span known = span;
        return known == null ? Instant.EPOCH : known.newest;
    }

    @Override
    public long nanos() {
        Span known = span;
        return known == null ? 0 : Duration.between(known.first, known.newest).toNanos();
    }
}
