package rsal.player;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import java.util.function.Supplier;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Waits for what a server that lives on real time does to our side.
public final class Waiting {
    private static final Duration PERIOD = Duration.ofMillis(1);
    private static final int LONGEST = 20; // s

    private Waiting() {}

    /// The first value that holds. It is asked for again and again, on the scheduler's thread.
    ///
    /// @throws AssertionError with the last value when none has held for 20 s
    public static <T> T until(Scheduler scheduler, Supplier<T> value, Predicate<T> holds) {
        var found = new CompletableFuture<T>();
        var last = new AtomicReference<T>();
        Task looking = scheduler.every(PERIOD, () -> {
            T now = value.get();
            last.set(now);
            if (holds.test(now)) {
                found.complete(now);
            }
        });
        try {
            return found.orTimeout(LONGEST, TimeUnit.SECONDS).join();
        } catch (CompletionException e) {
            throw new AssertionError("After %d s it is still '%s'.".formatted(LONGEST, last.get()), e);
        } finally {
            looking.cancel();
        }
    }
}
