package rsal.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
import java.util.function.Supplier;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/// What it does by a time that the test drives, and by that of the machine. That it is a [Scheduler] is shown
/// by the contract of these in the testkit.
class WallSchedulerTest {
    private static final Instant BEGINNING = Instant.ofEpochSecond(100);

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final List<String> ran = new CopyOnWriteArrayList<>();
    private final ExecutorService workers = Executors.newFixedThreadPool(2);
    private final WallScheduler real = new WallScheduler("run-real", workers, failures::add);
    private final DrivenTime time = new DrivenTime(reset -> failures.add(new AssertionError(reset)));
    private final WallScheduler driven = new WallScheduler(
            "run-driven", workers, failures::add, new PhaseTimes(() -> 0, () -> 0), Optional.of(time));

    WallSchedulerTest() {
        time.set(BEGINNING);
    }

    @AfterEach
    void tearDown() {
        real.close();
        driven.close();
        workers.close();
    }

    private static Duration ms(long ms) {
        return Duration.ofMillis(ms);
    }

    /// It is that long after the beginning.
    private void at(long ms) {
        time.set(BEGINNING.plusMillis(ms));
        settle(driven);
    }

    private Runnable note(String name) {
        return () -> ran.add("%d %s".formatted(time.nanos() / 1_000_000, name));
    }

    private static <T> T await(CompletableFuture<T> future) {
        try {
            return future.get(10, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    private static <T> T on(Scheduler scheduler, Supplier<T> code) {
        var result = new CompletableFuture<T>();
        scheduler.execute(() -> result.complete(code.get()));
        return await(result);
    }

    /// Lets everything run that is due: this comes after all of it.
    private static void settle(WallScheduler scheduler) {
        var settled = new CompletableFuture<String>();
        scheduler.after(Duration.ZERO, Phase.OBSERVE, () -> settled.complete("settled"));
        await(settled);
    }

    @Test
    void earlierTasksComeFirstThenEarlierPhasesThenThoseScheduledBefore() {
        on(driven, () -> {
            driven.after(ms(20), note("late"));
            driven.after(ms(10), Phase.OBSERVE, note("observe"));
            driven.after(ms(10), Phase.THINK, note("think 1"));
            driven.after(ms(10), Phase.THINK, note("think 2"));
            driven.after(ms(10), Phase.THINK, note("think 3"));
            driven.after(ms(10), Phase.WORLD, note("world"));
            return driven.after(ms(5), Phase.OBSERVE, note("early"));
        });
        at(4);
        assertThat(ran).isEmpty();
        at(20);
        assertThat(ran)
                .containsExactly(
                        "20 early", "20 world", "20 think 1", "20 think 2", "20 think 3", "20 observe", "20 late");
    }

    /// What is handed in has the first phase, and is due at once, also where the delay is less than none.
    @Test
    void whatIsHandedInRunsBeforeWhatIsDueAtTheSameTime() {
        on(driven, () -> {
            driven.after(ms(-50), note("none"));
            driven.after(Duration.ZERO, Phase.OBSERVE, note("observe"));
            driven.execute(note("handed in"));
            return driven.after(ms(1), Phase.WORLD, note("later"));
        });
        at(0); // what is due runs before time goes on
        at(1);
        assertThat(ran).containsExactly("0 handed in", "0 none", "0 observe", "1 later");
    }

    /// The beats are at 10, 20, 30 ms, …: one that was missed is not made up for, and does not move those that
    /// come.
    @Test
    void skipsTheBeatsItMissed() {
        on(driven, () -> driven.every(ms(10), note("beat")));
        for (int now : new int[] {9, 10, 19, 20, 25, 57, 59, 60, 79, 110}) {
            at(now);
        }
        assertThat(ran).containsExactly("10 beat", "20 beat", "57 beat", "60 beat", "79 beat", "110 beat");
    }

    @Test
    void aPeriodicTaskRunsAfterTasksThatWereScheduledBeforeItsLastTurn() {
        on(driven, () -> {
            driven.every(ms(10), note("period"));
            return driven.after(ms(20), note("once"));
        });
        at(10);
        at(20);
        assertThat(ran).containsExactly("10 period", "20 once", "20 period");
    }

    @Test
    void aPeriodMustBePositive() {
        for (Scheduler scheduler : List.of(real, driven, driven.inRealTime())) {
            for (int period : new int[] {0, -1}) {
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> scheduler.every(ms(period), note("never")))
                        .withMessageContaining("positive");
            }
            scheduler.every(Duration.ofNanos(1), () -> {}).cancel();
        }
    }

    @Test
    void whatIsCancelledDoesNotRunAndWhatFollowsDoes() {
        Task once = driven.after(ms(10), note("once"));
        Task again = driven.every(ms(10), note("again"));
        driven.after(ms(10), note("other"));
        once.cancel();
        at(10);
        again.cancel();
        at(30);
        assertThat(ran).containsExactly("10 again", "10 other");
    }

    /// Its thread sleeps until the time changes, or something is handed in that is due earlier than all else.
    @Test
    void wakesUpAtTheVeryTimeAtWhichSomethingIsDue() {
        var beats = new ArrayList<CompletableFuture<Instant>>();
        for (int beat = 1; beat <= 50; beat++) {
            var come = new CompletableFuture<Instant>();
            beats.add(come);
            driven.after(ms(beat), () -> come.complete(driven.instant()));
        }
        for (int beat = 1; beat <= 50; beat++) {
            time.set(BEGINNING.plusMillis(beat));
            assertThat(await(beats.get(beat - 1))).isEqualTo(BEGINNING.plusMillis(beat));
        }
    }

    @Test
    void whatIsDueEarlierWakesItUp() {
        real.after(Duration.ofHours(1), note("in an hour"));
        for (int i = 0; i < 20; i++) {
            int number = i;
            var soon = new CompletableFuture<Integer>();
            real.after(ms(1), () -> soon.complete(number));
            assertThat(await(soon)).isEqualTo(number);
        }
        assertThat(ran).isEmpty();
    }

    @Test
    void realTimeGoesOnWhileTheDrivenOneStands() {
        Scheduler inRealTime = driven.inRealTime();
        driven.every(ms(1), note("never"));
        Instant before = inRealTime.instant();
        var late = new CompletableFuture<Instant>();
        inRealTime.after(ms(20), Phase.THINK, () -> late.complete(inRealTime.instant()));
        assertThat(Duration.between(before, await(late))).isGreaterThanOrEqualTo(ms(20));
        var third = new CompletableFuture<Instant>();
        var beats = new AtomicInteger();
        Task beat = inRealTime.every(ms(1), Phase.THINK, () -> {
            if (beats.incrementAndGet() == 3) {
                third.complete(driven.instant());
            }
        });
        assertThat(await(third)).isEqualTo(BEGINNING);
        beat.cancel();
        assertThat(ran).isEmpty();
    }

    @Test
    void inRealTimeItIsTheSameThreadOfTheSameRun() {
        Scheduler inRealTime = driven.inRealTime();
        assertThat(inRealTime).isNotEqualTo(driven);
        assertThat(inRealTime.run()).isEqualTo(driven.run()).isNotNull();
        assertThat(real.inRealTime()).isEqualTo(real);
        Thread thread = on(driven, Thread::currentThread);
        assertThat(on(inRealTime, Thread::currentThread)).isEqualTo(thread);
        var threads = new ArrayList<Thread>();
        inRealTime.exclusively(() -> threads.add(Thread.currentThread()));
        assertThat(threads).containsExactly(Thread.currentThread());
        for (Scheduler one : List.of(driven, inRealTime)) {
            var computed = new CompletableFuture<Thread>();
            on(
                    one,
                    () -> one.compute(() -> 6 * 7)
                            .thenAccept(value -> computed.complete(value == 42 ? Thread.currentThread() : null)));
            assertThat(await(computed)).isEqualTo(thread);
            var error = new CompletableFuture<Throwable>();
            one.compute(() -> {
                        throw new IllegalStateException("can't be computed");
                    })
                    .whenComplete((_, e) -> error.complete(e));
            assertThat(await(error)).hasMessageContaining("can't be computed");
        }
    }

    /// It keeps motors safe.
    @Test
    void whatIsDueInRealTimeComesFirst() {
        on(driven, () -> {
            driven.execute(note("driven"));
            return driven.inRealTime().after(Duration.ZERO, Phase.OBSERVE, note("real"));
        });
        settle(driven);
        assertThat(ran).containsExactly("0 real", "0 driven");
    }

    @Test
    void itsTimeIsThatOfTheMachine() {
        Instant now = Instant.now();
        assertThat(real.instant()).isBetween(now.minusSeconds(60), now.plusSeconds(60));
        assertThat(driven.inRealTime().instant()).isBetween(now.minusSeconds(60), now.plusSeconds(60));
        assertThat(driven.instant()).isEqualTo(BEGINNING);
    }

    @Test
    void whatATaskThrowsGoesToTheHandlerAndItLivesOn() {
        driven.every(ms(10), () -> {
            throw new IllegalStateException("at " + time.nanos() / 1_000_000);
        });
        at(10);
        at(20);
        at(30);
        assertThat(failures).extracting(Throwable::getMessage).containsExactly("at 10", "at 20", "at 30");
    }

    @Test
    void aHandlerThatThrowsDoesNotEndItEither() {
        List<LogRecord> logged = logged(() -> {
            try (var fragile = new WallScheduler("run-fragile", workers, _ -> {
                throw new AssertionError("The handler of a test.");
            })) {
                fragile.execute(() -> {
                    throw new IllegalStateException("A task of a test.");
                });
                assertThat(on(fragile, () -> "still there")).isEqualTo("still there");
            }
        });
        assertThat(logged).singleElement().satisfies(record -> {
            assertThat(record.getMessage()).isEqualTo("The handler of failures failed itself.");
            assertThat(record.getThrown()).hasMessage("The handler of a test.");
        });
    }

    @Test
    void withoutAHandlerItLogsWhatTasksThrow() {
        List<LogRecord> logged = logged(() -> {
            try (var plain = new WallScheduler("run-plain", workers)) {
                plain.exclusively(() -> {
                    throw new IllegalStateException("A task of a test.");
                });
            }
        });
        assertThat(logged).singleElement().satisfies(record -> {
            assertThat(record.getMessage()).isEqualTo("A task of 'run-plain' failed.");
            assertThat(record.getThrown()).hasMessage("A task of a test.");
        });
    }

    /// What is logged meanwhile, which nobody else gets.
    private static List<LogRecord> logged(Runnable code) {
        var records = new CopyOnWriteArrayList<LogRecord>();
        var noting = new Handler() {
            @Override
            public void publish(LogRecord reported) {
                records.add(reported);
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
        };
        Logger log = Logger.getLogger(WallScheduler.class.getName());
        log.addHandler(noting);
        log.setUseParentHandlers(false);
        try {
            code.run();
        } finally {
            log.setUseParentHandlers(true);
            log.removeHandler(noting);
        }
        return records;
    }

    @Test
    void anInterruptDoesNotEndIt() {
        real.execute(() -> Thread.currentThread().interrupt());
        var later = new CompletableFuture<String>();
        real.after(ms(5), () -> later.complete("alive"));
        assertThat(await(later)).isEqualTo("alive");
    }

    @Test
    void itsThreadHasItsNameAndKeepsNoProgramAlive() {
        Thread thread = on(real, Thread::currentThread);
        assertThat(thread.getName()).isEqualTo("run-real");
        assertThat(thread.isDaemon()).isTrue();
    }

    @Test
    void closedItRunsNothingMore() {
        Thread thread = on(driven, Thread::currentThread);
        driven.every(ms(1), note("beat"));
        driven.inRealTime().after(Duration.ofHours(1), note("in an hour"));
        at(1);
        driven.close();
        driven.close();
        assertThat(thread.isAlive()).isFalse();
        assertThat(Thread.currentThread().isInterrupted()).isFalse();
        time.set(BEGINNING.plusSeconds(1));
        driven.execute(note("handed in"));
        driven.after(Duration.ZERO, note("after"));
        driven.exclusively(note("exclusively"));
        assertThat(ran).containsExactly("1 beat");
        assertThat(failures).isEmpty();
    }

    @Test
    void anInterruptWhileItIsClosedIsKeptForWhoAsksForIt() {
        Thread thread = on(real, Thread::currentThread);
        Thread.currentThread().interrupt();
        real.close();
        assertThat(thread.isAlive()).isFalse();
        assertThat(Thread.interrupted()).isTrue();
    }

    @Test
    void aTaskMayCloseIt() {
        var closed = new CompletableFuture<Thread>();
        real.execute(() -> {
            real.close();
            closed.complete(Thread.currentThread());
        });
        Thread thread = await(closed);
        real.close(); // waits for the end
        assertThat(thread.isAlive()).isFalse();
    }

    @Test
    void closedItWaitsForWhatRunsExclusively() throws InterruptedException {
        var closed = new CountDownLatch(1);
        var closing = new AtomicLong();
        real.exclusively(() -> {
            Thread.ofPlatform().start(() -> {
                real.close();
                closing.set(ran.size());
                closed.countDown();
            });
            try {
                assertThat(closed.await(20, TimeUnit.MILLISECONDS)).isFalse();
            } catch (InterruptedException e) {
                throw new AssertionError(e);
            }
            note("exclusively").run();
        });
        assertThat(closed.await(10, TimeUnit.SECONDS)).isTrue();
        assertThat(closing).hasValue(1);
        assertThat(failures).isEmpty();
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
                    real.exclusively(task);
                    real.exclusively(() -> threads.add(Thread.currentThread()));
                });
                real.execute(task);
            }
        }
        settle(real);
        assertThat(together).hasValue(0);
        assertThat(done).hasValue(2000);
        assertThat(threads).doesNotContain(on(real, Thread::currentThread)).hasSize(1000);
    }

    @Test
    void whatIsCancelledWhileItWaitsForItsTurnDoesNotRun() {
        for (int i = 0; i < 50; i++) {
            var due = new CountDownLatch(1);
            real.exclusively(() -> {
                Task task = real.after(Duration.ZERO, note("cancelled"));
                try {
                    assertThat(due.await(2, TimeUnit.MILLISECONDS)).isFalse(); // it is due, and waits
                } catch (InterruptedException e) {
                    throw new AssertionError(e);
                }
                task.cancel();
            });
        }
        settle(real);
        assertThat(ran).isEmpty();
        assertThat(failures).isEmpty();
    }

    @Test
    void whatFailsExclusivelyGoesToTheHandler() {
        real.exclusively(() -> {
            throw new IllegalStateException("a slip");
        });
        assertThat(failures).singleElement().extracting(Throwable::getMessage).isEqualTo("a slip");
    }

    @Test
    void reportsWhatEachPhaseTakes() {
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
                        timed.after(ms(1), Phase.OBSERVE, () -> done.complete("done"));
                    });
            await(done);
            timed.exclusively(() -> {}); // what was before is through
            clock.addAndGet(60_000); // between: counts for nobody
            timed.exclusively(() -> clock.addAndGet(5_000));
        }
        assertThat(times.of(Phase.WORLD)).isEqualTo(Duration.ofNanos(23));
        assertThat(times.of(Phase.DEVICES)).isEqualTo(Duration.ofNanos(400));
        assertThat(times.of(Phase.THINK)).isEqualTo(Duration.ofNanos(5_000));
        assertThat(times.of(Phase.OBSERVE)).isZero();
    }
}
