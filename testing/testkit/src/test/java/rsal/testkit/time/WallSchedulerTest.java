package rsal.testkit.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rsal.testkit.contract.SchedulerContract;
import rsal.time.Phase;
import rsal.time.PhaseTimes;
import rsal.time.Scheduler;
import rsal.time.WallScheduler;

class WallSchedulerTest extends SchedulerContract {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ExecutorService workers = Executors.newFixedThreadPool(2);
    private final WallScheduler scheduler = new WallScheduler("run-test", workers, failures::add);

    @AfterEach
    void tearDown() {
        scheduler.close();
        workers.close();
    }

    @Override
    protected Scheduler scheduler() {
        return scheduler;
    }

    @Override
    protected <T> T await(CompletableFuture<T> future) {
        try {
            return future.get(10, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void whatATaskThrowsGoesToTheHandlerAndItLivesOn() {
        var beats = new AtomicInteger();
        var third = new CompletableFuture<String>();
        scheduler.every(millis(2), () -> {
            if (beats.incrementAndGet() == 3) {
                third.complete("third");
            }
            throw new IllegalStateException("beat " + beats);
        });
        await(third);
        settle();
        assertThat(failures).hasSizeGreaterThanOrEqualTo(3);
        assertThat(failures.getFirst()).hasMessage("beat 1");
    }

    @Test
    void aHandlerThatThrowsDoesNotEndItEither() {
        try (var fragile = new WallScheduler("run-fragile", workers, _ -> {
            throw new AssertionError("The handler of a test.");
        })) {
            fragile.execute(() -> {
                throw new IllegalStateException("A task of a test.");
            });
            var after = new CompletableFuture<String>();
            fragile.execute(() -> after.complete("still there"));
            assertThat(await(after)).isEqualTo("still there");
        }
    }

    @Test
    void skipsTheBeatsItMissed() {
        var beats = new ArrayList<Instant>();
        var enough = new CompletableFuture<String>();
        scheduler.every(millis(10), () -> {
            beats.add(scheduler.instant());
            if (beats.size() == 1) {
                block(millis(100));
            }
            if (beats.size() == 4) {
                enough.complete("enough");
            }
        });
        await(enough);
        long periods = Duration.between(beats.get(0), beats.get(3)).dividedBy(millis(10));
        assertThat(periods).as("periods in which 3 beats came").isGreaterThanOrEqualTo(10);
    }

    @Test
    void anInterruptDoesNotEndIt() {
        scheduler.execute(() -> Thread.currentThread().interrupt());
        pass(millis(5));
        assertThat(onScheduler(() -> "alive")).isEqualTo("alive");
    }

    @Test
    void itsThreadHasItsNameAndKeepsNoProgramAlive() {
        Thread thread = onScheduler(Thread::currentThread);
        assertThat(thread.getName()).isEqualTo("run-test");
        assertThat(thread.isDaemon()).isTrue();
    }

    @Test
    void closedItRunsNothingMore() {
        var ran = new AtomicInteger();
        Thread thread = onScheduler(Thread::currentThread);
        scheduler.every(millis(1), ran::incrementAndGet);
        pass(millis(10));
        scheduler.close();
        scheduler.close();
        int before = ran.get();
        assertThat(thread.isAlive()).isFalse();
        scheduler.execute(ran::incrementAndGet);
        scheduler.after(Duration.ZERO, ran::incrementAndGet);
        assertThat(ran).hasValue(before);
    }

    @Test
    void aTaskMayCloseIt() {
        var closed = new CompletableFuture<Thread>();
        scheduler.execute(() -> {
            scheduler.close();
            closed.complete(Thread.currentThread());
        });
        Thread thread = await(closed);
        scheduler.close(); // waits for the end
        assertThat(thread.isAlive()).isFalse();
    }

    private static void block(Duration time) {
        try {
            assertThat(new CountDownLatch(1).await(time.toMillis(), TimeUnit.MILLISECONDS))
                    .isFalse();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void whatOthersRunExclusivelyRunsOnTheirThreadAndNeverBesideATask() {
        var running = new AtomicInteger();
        var together = new AtomicInteger();
        var done = new AtomicInteger();
        Runnable task = () -> {
            if (running.incrementAndGet() > 1) {
                together.incrementAndGet();
            }
            done.incrementAndGet();
            running.decrementAndGet();
        };
        var threads = new CopyOnWriteArrayList<Thread>();
        try (ExecutorService others = Executors.newFixedThreadPool(2)) {
            for (int i = 0; i < 1000; i++) {
                others.execute(() -> {
                    scheduler.exclusively(task);
                    scheduler.exclusively(() -> threads.add(Thread.currentThread()));
                });
                scheduler.execute(task);
            }
        }
        settle();
        assertThat(together).hasValue(0);
        assertThat(done).hasValue(2000);
        assertThat(threads).doesNotContain(onScheduler(Thread::currentThread)).hasSize(1000);
    }

    @Test
    void whatIsCancelledWhileItWaitsForItsTurnDoesNotRun() throws Exception {
        var ran = new AtomicInteger();
        for (int i = 0; i < 50; i++) {
            var due = new CountDownLatch(1);
            scheduler.exclusively(() -> {
                var task = scheduler.after(Duration.ZERO, ran::incrementAndGet);
                try {
                    assertThat(due.await(2, TimeUnit.MILLISECONDS)).isFalse(); // it is due, and waits
                } catch (InterruptedException e) {
                    throw new AssertionError(e);
                }
                task.cancel();
            });
        }
        settle();
        assertThat(ran).hasValue(0);
        assertThat(failures).isEmpty();
    }

    @Test
    void whatFailsExclusivelyGoesToTheHandler() {
        scheduler.exclusively(() -> {
            throw new IllegalStateException("a slip");
        });
        assertThat(failures).singleElement().extracting(Throwable::getMessage).isEqualTo("a slip");
    }

    @Test
    void nothingRunsExclusivelyOnceItIsClosed() {
        scheduler.close();
        scheduler.exclusively(() -> failures.add(new AssertionError("It ran.")));
        assertThat(failures).isEmpty();
    }

    @Test
    void tellsWhatEachPhaseTakes() {
        var clock = new AtomicLong();
        var times = new PhaseTimes(clock::get, () -> 0);
        try (var timed = new WallScheduler("run-timed", workers, failures::add, times)) {
            var done = new CompletableFuture<String>();
            timed.execute(
                    () -> { // as what comes from outside
                        clock.addAndGet(3);
                        timed.exclusively(() -> clock.addAndGet(20)); // within a task, its own
                        timed.after(Duration.ZERO, Phase.DEVICES, () -> {
                            clock.addAndGet(400);
                            throw new IllegalStateException("a slip that takes time, too");
                        });
                        timed.after(millis(1), Phase.OBSERVE, () -> done.complete("done"));
                    });
            await(done);
            timed.exclusively(() -> clock.addAndGet(5_000));
        }
        assertThat(times.of(Phase.WORLD)).isEqualTo(Duration.ofNanos(23));
        assertThat(times.of(Phase.DEVICES)).isEqualTo(Duration.ofNanos(400));
        assertThat(times.of(Phase.THINK)).isEqualTo(Duration.ofNanos(5_000));
        assertThat(times.of(Phase.OBSERVE)).isZero();
    }
}
