package rsal.testkit.time;

import static org.assertj.core.api.Assertions.assertThat;

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
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.testkit.contract.SchedulerContract;
import rsal.time.DrivenTime;
import rsal.time.PhaseTimes;
import rsal.time.Scheduler;
import rsal.time.WallScheduler;

/// A scheduler whose time the test drives, a millisecond at a time while it waits for something.
class DrivenSchedulerTest extends SchedulerContract {
    private static final Instant BEGINNING = Instant.ofEpochSecond(100);

    private final List<String> resets = new CopyOnWriteArrayList<>();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ExecutorService workers = Executors.newFixedThreadPool(2);
    private final DrivenTime time = new DrivenTime(resets::add);
    private final WallScheduler scheduler = new WallScheduler(
            "run-driven", workers, failures::add, new PhaseTimes(() -> 0, () -> 0), Optional.of(time));

    @BeforeEach
    void begin() {
        time.set(BEGINNING);
    }

    @AfterEach
    void tearDown() {
        scheduler.close();
        workers.close();
        assertThat(failures).isEmpty();
    }

    @Override
    protected Scheduler scheduler() {
        return scheduler;
    }

    @Override
    protected <T> T await(CompletableFuture<T> future) {
        for (int i = 0; i < 10_000; i++) {
            try {
                return future.get(1, TimeUnit.MILLISECONDS);
            } catch (TimeoutException _) {
                time.set(time.instant().plusMillis(1));
            } catch (InterruptedException | ExecutionException e) {
                throw new AssertionError(e);
            }
        }
        throw new AssertionError("It takes too long.");
    }

    private static <T> T really(CompletableFuture<T> future) {
        try {
            return future.get(10, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void nothingIsDueWhileTimeStandsButWhatIsInRealTime() {
        var ran = new AtomicInteger();
        var real = new CompletableFuture<Instant>();
        scheduler.every(millis(1), ran::incrementAndGet);
        Scheduler inRealTime = scheduler.inRealTime();
        Instant before = inRealTime.instant();
        inRealTime.after(millis(50), () -> real.complete(scheduler.instant()));
        assertThat(really(real)).isEqualTo(BEGINNING);
        assertThat(ran).hasValue(0);
        assertThat(Duration.between(before, inRealTime.instant())).isGreaterThanOrEqualTo(millis(50));
        assertThat(inRealTime.run()).isEqualTo(scheduler.run());
        assertThat(inRealTime.inRealTime()).isEqualTo(inRealTime);
        pass(millis(5));
        assertThat(ran).hasValueGreaterThan(2);
    }

    @Test
    void timeThatJumpsAheadRunsEachOnceInOrder() {
        var ran = new ArrayList<String>();
        onScheduler(() -> {
            scheduler.after(Duration.ofSeconds(2), () -> ran.add("second"));
            scheduler.after(Duration.ofSeconds(1), () -> ran.add("first"));
            return scheduler.every(Duration.ofMillis(2_500), () -> ran.add("beat"));
        });
        time.set(BEGINNING.plusSeconds(1_000));
        settle();
        assertThat(ran).containsExactly("first", "second", "beat");
    }

    @Test
    void whatWasScheduledBeforeItsBeginningCountsFromThere() {
        var late = new DrivenTime(resets::add);
        try (var waiting = new WallScheduler(
                "run-late", workers, failures::add, new PhaseTimes(() -> 0, () -> 0), Optional.of(late))) {
            assertThat(waiting.instant()).isEqualTo(Instant.EPOCH);
            var ran = new CompletableFuture<Instant>();
            waiting.after(Duration.ofSeconds(3), () -> ran.complete(waiting.instant()));
            late.set(BEGINNING);
            late.set(BEGINNING.plusSeconds(2));
            var settled = new CompletableFuture<String>();
            waiting.execute(() -> settled.complete("settled"));
            really(settled);
            assertThat(ran).isNotDone();
            late.set(BEGINNING.plusSeconds(4));
            assertThat(really(ran)).isEqualTo(BEGINNING.plusSeconds(4));
        }
    }

    /// Those who drive the time may wait for that.
    @Test
    void whatItHasReachedIsSaidWhenNothingIsLeftToDo() throws Exception {
        var late = new DrivenTime(resets::add);
        var reached = new LinkedBlockingQueue<Instant>();
        late.onReached(reached::add);
        try (var following = new WallScheduler(
                "run-reached", workers, failures::add, new PhaseTimes(() -> 0, () -> 0), Optional.of(late))) {
            var computing = new CountDownLatch(1);
            var done = new CopyOnWriteArrayList<String>();
            following.after(millis(5), () -> {
                done.add("due");
                following
                        .compute(() -> {
                            try {
                                return computing.await(10, TimeUnit.SECONDS);
                            } catch (InterruptedException e) {
                                throw new AssertionError(e);
                            }
                        })
                        .thenAccept(_ -> following.execute(() -> done.add("computed")));
            });
            late.set(BEGINNING);
            assertThat(reached.poll(10, TimeUnit.SECONDS)).isEqualTo(BEGINNING);
            late.set(BEGINNING.plusMillis(4)); // nothing is due, which is said, too
            assertThat(reached.poll(10, TimeUnit.SECONDS)).isEqualTo(BEGINNING.plusMillis(4));
            late.set(BEGINNING.plusMillis(6));
            assertThat(reached.poll(200, TimeUnit.MILLISECONDS))
                    .as("somebody still computes")
                    .isNull();
            assertThat(done).containsExactly("due");
            computing.countDown();
            assertThat(reached.poll(10, TimeUnit.SECONDS)).isEqualTo(BEGINNING.plusMillis(6));
            assertThat(done).containsExactly("due", "computed");
            late.set(BEGINNING.plusMillis(6));
            assertThat(reached.poll(50, TimeUnit.MILLISECONDS))
                    .as("it is no new time")
                    .isNull();
        }
    }

    @Test
    void itNeverGoesBackAndResetsAreSaid() {
        time.set(BEGINNING.plusSeconds(2));
        time.set(BEGINNING.plusMillis(1_100)); // messages that overtook each other
        assertThat(resets).isEmpty();
        assertThat(scheduler.instant()).isEqualTo(BEGINNING.plusSeconds(2));
        time.set(Instant.ofEpochMilli(500));
        assertThat(resets)
                .containsExactly("The time of the simulator, which the run follows, went back from 102.0 s to 0.5 s."
                        + " Start the run again after a reset.");
        assertThat(scheduler.instant()).isEqualTo(BEGINNING.plusSeconds(2));
    }
}
