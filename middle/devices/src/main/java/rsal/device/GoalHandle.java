package rsal.device;

import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import rsal.data.Stamped;

/// A goal under way: feedback `F` while it lasts, exactly one result `R` at its end.
public interface GoalHandle<F, R> {
    Subscription onFeedback(Consumer<? super Stamped<F>> listener);

    /// Completes once, normally, on the scheduler's thread; failure is a result, not an exception.
    CompletionStage<R> result();

    /// Asks for an early end. After the end it does nothing.
    void cancel();

    /// This goal and then another, as one: when this ended well the next begins, else its result is that of both.
    ///
    /// @param well whether a result is what was wanted
    /// @param next begins the other goal
    default GoalHandle<F, R> then(Predicate<? super R> well, Supplier<? extends GoalHandle<F, R>> next) {
        return GoalPair.of(this, well, next);
    }
}
