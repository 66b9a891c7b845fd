package rsal.device;

import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.data.Stamped;

/// A goal under way: feedback `F` while it lasts, exactly one result `R` at its end.
public interface GoalHandle<F, R> {
    Subscription onFeedback(Consumer<? super Stamped<F>> listener);

    /// Completes once, normally, on the scheduler's thread; failure is a result, not an exception.
    CompletionStage<R> result();

    /// Asks for an early end. After the end it does nothing.
    void cancel();
}
