package rsal.device;

import java.util.function.Predicate;
import java.util.function.Supplier;

/// Two goals, one after the other, that look like one.
final class GoalPair<F, R> {
    private final GoalSource<F, R> both = new GoalSource<>(this::cancel);
    private GoalHandle<F, R> inProgress;

    private GoalPair(GoalHandle<F, R> first) {
        this.inProgress = first;
    }

    static <F, R> GoalHandle<F, R> of(
            GoalHandle<F, R> first, Predicate<? super R> well, Supplier<? extends GoalHandle<F, R>> next) {
        var pair = new GoalPair<>(first);
        pair.follow(first);
        first.result().thenAccept(result -> {
            if (well.test(result)) {
                pair.inProgress = next.get();
                pair.follow(pair.inProgress);
                pair.inProgress.result().thenAccept(pair.both::end);
            } else {
                pair.both.end(result);
            }
        });
        return pair.both;
    }

    private void follow(GoalHandle<F, R> goal) {
        goal.onFeedback(both::publish);
    }

    private void cancel() {
        inProgress.cancel();
    }
}
