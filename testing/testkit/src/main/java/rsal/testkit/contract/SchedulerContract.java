package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// What every [Scheduler] owes.
public abstract class SchedulerContract {
    protected abstract Scheduler scheduler();

    /// Lets time pass until the stage has its ending, and gives that back; fails when it takes too long.
    protected abstract <T> T await(CompletableFuture<T> future);

    @Test
    void runsWhatItIsHandedInThatOrder() {
        var ran = new ArrayList<Integer>();
        for (int i = 0; i < 100; i++) {
            int number = i;
            scheduler().execute(() -> ran.add(number));
        }
        settle();
        assertThat(ran).hasSize(100).isSorted();
    }

    @Test
    void runsATaskOnceWhenItsTimeHasCome() {
        var times = new ArrayList<Instant>();
        Instant before = onScheduler(() -> {
            scheduler().after(millis(20), () -> times.add(scheduler().instant()));
            return scheduler().instant();
        });
        pass(millis(60));
        assertThat(times).hasSize(1);
        assertThat(times.getFirst()).isAfterOrEqualTo(before.plusMillis(20));
    }

    @Test
    void runsTasksInTheOrderOfTheirTimes() {
        var ran = new ArrayList<String>();
        onScheduler(() -> {
            scheduler().after(millis(60), Phase.WORLD, () -> ran.add("third"));
            scheduler().after(millis(20), Phase.THINK, () -> ran.add("first"));
            scheduler().after(millis(40), Phase.OBSERVE, () -> ran.add("second"));
            return ran;
        });
        pass(millis(100));
        assertThat(ran).containsExactly("first", "second", "third");
    }

    @Test
    void timeNeverGoesBack() {
        var times = new ArrayList<Instant>();
        for (int i = 0; i < 20; i++) {
            scheduler().execute(() -> times.add(scheduler().instant()));
            onScheduler(() ->
                    scheduler().after(millis(3), () -> times.add(scheduler().instant())));
        }
        pass(millis(20));
        assertThat(times).hasSize(40).isSorted();
    }

    @Test
    void repeatsATaskUntilItIsCancelled() {
        var ran = new AtomicInteger();
        var tasks = new ArrayList<Task>();
        var cancelled = new CompletableFuture<String>();
        onScheduler(() -> tasks.add(scheduler().every(millis(5), () -> {
            if (ran.incrementAndGet() == 3) {
                tasks.getFirst().cancel();
                tasks.getFirst().cancel();
                cancelled.complete("cancelled");
            }
        })));
        await(cancelled); // a busy machine skips some of its turns
        pass(millis(20));
        assertThat(ran).hasValue(3);
    }

    @Test
    void aCancelledTaskDoesNotRun() {
        var ran = new ArrayList<String>();
        onScheduler(() -> {
            Task task = scheduler().after(millis(10), () -> ran.add("cancelled"));
            task.cancel();
            Task late = scheduler().after(millis(1), () -> ran.add("ran"));
            scheduler().after(millis(20), late::cancel);
            return task;
        });
        pass(millis(40));
        assertThat(ran).containsExactly("ran");
    }

    @Test
    void aPeriodMustBePositive() {
        assertThatIllegalArgumentException().isThrownBy(() -> scheduler().every(Duration.ZERO, () -> {}));
        assertThatIllegalArgumentException().isThrownBy(() -> scheduler().every(millis(-1), () -> {}));
    }

    @Test
    void withinGivesTheAnswerWhenItComesInTime() {
        var answer = new CompletableFuture<String>();
        var within = onScheduler(() -> {
            scheduler().after(millis(5), () -> answer.complete("yes"));
            return scheduler().within(Duration.ofMinutes(1), answer);
        });
        assertThat(await(within.toCompletableFuture())).isEqualTo("yes");
    }

    @Test
    void withinGivesTheErrorThatCame() {
        var answer = new CompletableFuture<String>();
        var within = onScheduler(() -> {
            scheduler().execute(() -> answer.completeExceptionally(new IllegalStateException("no")));
            return scheduler().within(Duration.ofMinutes(1), answer);
        });
        assertThat(await(failure(within))).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void withinGivesUpWhenItsTimeIsOver() {
        var within = onScheduler(() -> scheduler().within(millis(10), new CompletableFuture<String>()));
        assertThat(await(failure(within))).isInstanceOf(TimeoutException.class);
    }

    @Test
    void withinAnswersOnItsOwnThreadWhoeverAnswers() throws InterruptedException {
        var threads = new ArrayList<Thread>();
        var thread = onScheduler(Thread::currentThread);
        var answer = new CompletableFuture<String>();
        var within = onScheduler(() -> scheduler()
                .within(Duration.ofMinutes(1), answer)
                .whenComplete((_, _) -> threads.add(Thread.currentThread())));
        Thread.ofPlatform().start(() -> answer.complete("from elsewhere")).join();
        assertThat(await(within.toCompletableFuture())).isEqualTo("from elsewhere");
        assertThat(threads).containsExactly(thread);
    }

    @Test
    void computesBesideAndCompletesOnItsOwnThread() {
        var threads = new ArrayList<Thread>();
        var thread = onScheduler(Thread::currentThread);
        CompletableFuture<Integer> answer = onScheduler(() -> scheduler()
                .compute(() -> 6 * 7)
                .whenComplete((_, _) -> threads.add(Thread.currentThread()))
                .toCompletableFuture());
        assertThat(await(answer)).isEqualTo(42);
        assertThat(threads).containsExactly(thread);
    }

    @Test
    void whatAComputationThrowsIsItsAnswer() {
        CompletionStage<Object> answer = onScheduler(() -> scheduler().compute(() -> {
            throw new IllegalStateException("Computed that it can't.");
        }));
        assertThat(await(failure(answer))).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void takesTasksFromManyThreadsAndNeverRunsTwoAtOnce() throws InterruptedException {
        var ran = new ArrayList<List<Integer>>();
        var inside = new AtomicInteger();
        var overlaps = new AtomicInteger();
        var threads = new ArrayList<Thread>();
        for (int t = 0; t < 4; t++) {
            var mine = new ArrayList<Integer>();
            ran.add(mine);
            threads.add(Thread.ofPlatform().start(() -> {
                for (int i = 0; i < 1000; i++) {
                    int number = i;
                    scheduler().execute(() -> {
                        overlaps.addAndGet(inside.getAndIncrement());
                        mine.add(number);
                        inside.decrementAndGet();
                    });
                }
            }));
        }
        for (Thread thread : threads) {
            thread.join();
        }
        settle();
        assertThat(overlaps).hasValue(0);
        assertThat(ran).allSatisfy(mine -> assertThat(mine).hasSize(1000).isSorted());
    }

    protected static Duration millis(long millis) {
        return Duration.ofMillis(millis);
    }

    /// Runs something on the scheduler's thread.
    protected final <T> T onScheduler(java.util.function.Supplier<T> code) {
        var result = new CompletableFuture<T>();
        scheduler().execute(() -> result.complete(code.get()));
        return await(result);
    }

    /// Lets at least this much of the scheduler's time pass.
    protected final void pass(Duration time) {
        var over = new CompletableFuture<String>();
        onScheduler(() -> scheduler().after(time, Phase.OBSERVE, () -> over.complete("over")));
        await(over);
    }

    /// Lets everything run that was handed in.
    protected final void settle() {
        onScheduler(() -> "settled");
    }

    private static CompletableFuture<Throwable> failure(CompletionStage<?> stage) {
        var failure = new CompletableFuture<Throwable>();
        stage.whenComplete((_, error) ->
                failure.complete(error instanceof CompletionException wrapped ? wrapped.getCause() : error));
        return failure;
    }
}
