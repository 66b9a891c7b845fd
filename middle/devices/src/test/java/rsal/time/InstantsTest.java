package rsal.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/// In which order a [LockstepScheduler] runs what is due, and where its time stands then.
class InstantsTest {
    private final LockstepScheduler time = new LockstepScheduler();
    private final List<String> ran = new ArrayList<>();

    private static Duration ms(long ms) {
        return Duration.ofMillis(ms);
    }

    private Runnable note(String name) {
        return () -> ran.add("%d %s".formatted(time.elapsed().toMillis(), name));
    }

    @Test
    void earlierTasksComeFirstThenEarlierPhasesThenThoseScheduledBefore() {
        time.after(ms(20), note("late"));
        time.after(ms(10), Phase.OBSERVE, note("observe"));
        time.after(ms(10), Phase.THINK, note("think 1"));
        time.after(ms(10), Phase.THINK, note("think 2"));
        time.after(ms(10), Phase.WORLD, note("world"));
        time.advance(ms(30));
        assertThat(ran).containsExactly("10 world", "10 think 1", "10 think 2", "10 observe", "20 late");
        assertThat(time.elapsed()).isEqualTo(ms(30));
    }

    @Test
    void aPeriodicTaskRunsAfterTasksThatWereScheduledBeforeItsLastTurn() {
        time.every(ms(10), note("period"));
        time.after(ms(20), note("once"));
        time.advance(ms(30));
        assertThat(ran).containsExactly("10 period", "20 once", "20 period", "30 period");
    }

    @Test
    void periodicTasksOfOnePeriodKeepTheirOrder() {
        time.every(ms(10), note("a"));
        time.every(ms(10), note("b"));
        time.advance(ms(20));
        assertThat(ran).containsExactly("10 a", "10 b", "20 a", "20 b");
    }

    @Test
    void aPeriodCountsFromTheStartAndNotFromWhenATaskHasEnded() {
        time.advance(ms(5));
        time.every(ms(10), note("period"));
        time.advance(ms(7));
        time.advance(ms(24));
        assertThat(ran).containsExactly("15 period", "25 period", "35 period");
    }

    @Test
    void aTaskThatCancelsItselfOrAnotherIsObeyedAtOnce() {
        var tasks = new ArrayList<Task>();
        tasks.add(time.every(ms(10), () -> {
            note("first").run();
            tasks.forEach(Task::cancel);
        }));
        tasks.add(time.every(ms(10), note("second")));
        time.advance(ms(50));
        assertThat(ran).containsExactly("10 first");
    }

    @Test
    void whatATaskHandsInRunsAtTheSameInstantAndBeforeTheNextTask() {
        time.after(ms(10), () -> {
            note("a").run();
            time.execute(note("handed in"));
        });
        time.after(ms(10), note("b"));
        time.advance(ms(10));
        assertThat(ran).containsExactly("10 a", "10 handed in", "10 b");
    }

    @Test
    void computationsOfAPhaseCompleteAtItsEndInTheOrderInWhichTheyWereAskedFor() {
        time.after(ms(10), Phase.DEVICES, () -> {
            time.compute(() -> "1")
                    .thenAccept(value -> note("computed " + value).run());
            time.compute(() -> "2")
                    .thenAccept(value -> note("computed " + value).run());
            note("asked").run();
        });
        time.after(ms(10), Phase.DEVICES, note("another"));
        time.after(ms(10), Phase.THINK, note("think"));
        time.advance(ms(10));
        assertThat(ran).containsExactly("10 asked", "10 another", "10 computed 1", "10 computed 2", "10 think");
    }

    @Test
    void goesToTheNextInstantAtWhichSomethingIsDueAndNoFurther() {
        time.after(ms(10), note("a"));
        time.after(ms(10), note("b"));
        time.after(ms(30), note("c"));
        assertThat(time.advanceToNext(ms(50))).isTrue();
        assertThat(ran).containsExactly("10 a", "10 b");
        assertThat(time.elapsed()).isEqualTo(ms(10));
        assertThat(time.advanceToNext(ms(5))).isFalse();
        assertThat(time.elapsed()).isEqualTo(ms(15));
        assertThat(time.advanceToNext(ms(15))).as("its end counts").isTrue();
        assertThat(time.instant()).isEqualTo(Instant.EPOCH.plusMillis(30));
    }

    @Test
    void aDelayBelowZeroIsNone() {
        time.advance(ms(10));
        time.after(ms(-5), note("now"));
        time.advance(ms(0));
        assertThat(ran).containsExactly("10 now");
    }

    @Test
    void aTaskThatThrowsIsGoneAndAllOthersStay() {
        time.every(ms(10), note("before"));
        time.after(ms(10), () -> {
            throw new IllegalStateException("broken");
        });
        time.every(ms(10), note("after"));
        assertThatThrownBy(() -> time.advance(ms(20))).hasMessage("broken");
        assertThat(ran).containsExactly("10 before");
        time.advance(ms(10));
        assertThat(ran).containsExactly("10 before", "10 after", "20 before", "20 after");
    }

    @Test
    void whatIsForgottenNeverRuns() {
        time.after(ms(10), note("due"));
        time.every(ms(10), note("period"));
        time.execute(note("handed in"));
        time.drop();
        time.advance(ms(50));
        time.runPending();
        assertThat(ran).isEmpty();
    }

    @Test
    void otherThreadsTasksRunWithoutTimePassingWhenThatIsAskedFor() {
        time.advance(ms(10));
        CompletableFuture.runAsync(() -> time.execute(note("from outside"))).join();
        assertThat(ran).isEmpty();
        time.runPending();
        assertThat(ran).containsExactly("10 from outside");
    }

    @Test
    void whatIsForgottenIsNeverComputedNorCompleted() {
        time.execute(note("handed in")); // before the first advance: nobody knows whose thread the run's is
        time.after(ms(10), Phase.WORLD, () -> {
            time.compute(() -> "value").thenAccept(value -> note("computed").run());
            time.execute(note("next"));
            time.drop();
        });
        time.advance(ms(20));
        assertThat(ran).containsExactly("0 handed in");
    }

    @Test
    void aPeriodIsMoreThanNothing() {
        assertThatThrownBy(() -> time.every(Duration.ZERO, note("never")))
                .hasMessage("A period must be positive, not 'PT0S'.");
        assertThatThrownBy(() -> time.every(ms(-1), note("never"))).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void severalComputationsAreHandedToWorkersAndOneAloneIsNot() {
        var handedOver = new ArrayList<Runnable>();
        var beside = new LockstepScheduler(Instant.EPOCH, handedOver::add); // workers that never come
        var values = new ArrayList<Integer>();
        beside.after(ms(10), () -> beside.compute(() -> 1).thenAccept(values::add));
        beside.after(ms(20), () -> {
            beside.compute(() -> 2).thenAccept(values::add);
            beside.compute(() -> 3).thenAccept(values::add);
        });
        beside.advance(ms(10));
        assertThat(handedOver).isEmpty();
        assertThat(values).containsExactly(1);
        beside.advance(ms(10));
        assertThat(handedOver).hasSize(2);
        assertThat(values).as("the run's own thread computes what nobody took").containsExactly(1, 2, 3);
        handedOver.forEach(Runnable::run);
        assertThat(values).as("each is computed once").containsExactly(1, 2, 3);
    }

    @Test
    void anErrorOfAComputationIsItsAnswer() {
        time.after(
                ms(10),
                () -> time.compute(() -> {
                            throw new IllegalStateException("broken");
                        })
                        .exceptionally(error -> {
                            note("failed").run();
                            return "";
                        }));
        time.advance(ms(10));
        assertThat(ran).containsExactly("10 failed");
    }

    @Test
    void whatComputationsLeadToRunsBeforeTheNextPhase() {
        time.after(
                ms(10),
                Phase.DEVICES,
                () -> time.compute(() -> "1").thenAccept(_ -> {
                    time.execute(note("handed in"));
                    time.compute(() -> "2")
                            .thenAccept(_ -> note("computed again").run());
                }));
        time.after(ms(10), Phase.THINK, note("think"));
        time.advance(ms(10));
        assertThat(ran).containsExactly("10 handed in", "10 computed again", "10 think");
    }

    @Test
    void aRunThatIsPausedComputesWhatOthersAskFor() {
        CompletableFuture.runAsync(() -> time.execute(() -> time.compute(() -> "value")
                        .thenAccept(value -> note("computed " + value).run())))
                .join();
        time.runPending();
        assertThat(ran).containsExactly("0 computed value");
    }

    @Test
    void anInterruptionIsKeptForWhoAsksForIt() {
        time.after(ms(10), () -> {
            time.compute(() -> "value")
                    .thenAccept(value -> note("computed " + value).run());
            Thread.currentThread().interrupt();
        });
        time.advance(ms(10));
        assertThat(ran).containsExactly("10 computed value");
        assertThat(Thread.interrupted()).isTrue();
    }

    @Test
    void eachPhaseIsGivenTheTimeThatItTook() {
        var clock = new AtomicLong();
        var times = new PhaseTimes(clock::get, () -> 0);
        var timed = new LockstepScheduler(Instant.EPOCH, Runnable::run, times);
        clock.set(1_000); // before: counts for nobody
        timed.after(ms(10), Phase.WORLD, () -> clock.addAndGet(5));
        timed.after(ms(10), Phase.THINK, () -> clock.addAndGet(7));
        timed.after(ms(20), Phase.WORLD, () -> clock.addAndGet(11));
        timed.advance(ms(10));
        clock.addAndGet(100); // between
        timed.advanceToNext(ms(10));
        assertThat(times.of(Phase.WORLD)).isEqualTo(Duration.ofNanos(16));
        assertThat(times.of(Phase.THINK)).isEqualTo(Duration.ofNanos(7));
        assertThat(times.of(Phase.OBSERVE)).isZero();
    }
}
