package rsal.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
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
}
