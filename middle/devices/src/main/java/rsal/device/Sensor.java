package rsal.device;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.data.Stamped;

/// A device with readings.
public interface Sensor<T> extends Device {
    /// The newest reading; empty before the first.
    Optional<Stamped<T>> latest();

    /// Tells of each new reading, in the order in which they subscribed. A listener that throws loses its
    /// subscription, is reported, and harms nobody else.
    Subscription subscribe(Consumer<? super Stamped<T>> listener);

    /// The reading after now.
    default CompletionStage<Stamped<T>> next() {
        var next = new CompletableFuture<Stamped<T>>();
        var subscription = subscribe(next::complete);
        return next.whenComplete((_, _) -> subscription.cancel());
    }
}
