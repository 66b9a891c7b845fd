package rsal.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.data.Stamped;

/// The driver's side of a goal.
public final class GoalSource<F, R> implements GoalHandle<F, R> {
    private static final Logger LOG = System.getLogger(GoalHandle.class.getName());

    private final CompletableFuture<R> result = new CompletableFuture<>();
    private final Runnable onCancel;
    private final Listeners<Stamped<F>> feedback = new Listeners<>(
            e -> LOG.log(Level.ERROR, "A listener of a goal's feedback failed and is not notified any more.", e));

    /// @param onCancel asked to end the goal; it calls [#end]
    public GoalSource(Runnable onCancel) {
        this.onCancel = onCancel;
    }

    @Override
    public Subscription onFeedback(Consumer<? super Stamped<F>> listener) {
        return feedback.add(listener);
    }

    @Override
    public CompletionStage<R> result() {
        return result.minimalCompletionStage();
    }

    @Override
    public void cancel() {
        if (!ended()) {
            onCancel.run();
        }
    }

    public void publish(Stamped<F> progress) {
        if (!ended()) {
            feedback.publish(progress);
        }
    }

    /// The first ending counts.
    ///
    /// @return whether this was the first
    public boolean end(R ending) {
        return result.complete(ending);
    }

    public boolean ended() {
        return result.isDone();
    }
}
