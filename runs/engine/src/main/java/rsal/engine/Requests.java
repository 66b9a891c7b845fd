package rsal.engine;

import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Function;
import java.util.function.Supplier;
import rsal.engine.report.Answer;

/// What any thread asks of a run. It waits until the run's thread comes to it.
final class Requests {
    private final Queue<Runnable> waiting = new ConcurrentLinkedQueue<>();
    private final CompletableFuture<Answer> tooLate;

    /// @param tooLate answers what is not answered when the run ends. One for all: a stage of each request that hangs
    /// on the end itself would stay until then
    Requests(CompletableFuture<Answer> tooLate) {
        this.tooLate = tooLate;
    }

    /// @param answer made on the run's thread
    CompletionStage<Answer> ask(Supplier<Answer> answer) {
        if (tooLate.isDone()) {
            return tooLate.minimalCompletionStage(); // nobody takes it any more
        }
        var answered = new CompletableFuture<Answer>();
        waiting.add(() -> answered.complete(answer.get()));
        return answered.applyToEither(tooLate, Function.identity());
    }

    /// Answers all. On the run's thread.
    void take() {
        for (Runnable next = waiting.poll(); next != null; next = waiting.poll()) {
            next.run();
        }
    }
}
