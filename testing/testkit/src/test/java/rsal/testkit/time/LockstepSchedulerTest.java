package rsal.testkit.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.Future.State;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.testkit.contract.SchedulerContract;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;
import rsal.time.PhaseTimes;
import rsal.time.Scheduler;
import rsal.time.Task;

class LockstepSchedulerTest extends SchedulerContract {
    private final LockstepScheduler run = new LockstepScheduler();

    @Override
    protected Scheduler scheduler() {
        return run;
    }

    @Override
    protected <T> T await(CompletableFuture<T> future) {
        run.runPending();
        for (int i = 0; i < 1000 && !future.isDone(); i++) {
            run.advanceToNext(Duration.ofMillis(10));
        }
        assertThat(future.state()).isEqualTo(State.SUCCESS);
        return future.resultNow();
    }

    @Test
    void timeStandsStillWhileTasksRunAndJumpsBetweenThem() {
        var times = new ArrayList<Duration>();
        run.every(Duration.ofMillis(30), () -> times.add(run.elapsed()));
        run.advance(Duration.ofMillis(100));
        assertThat(times).containsExactly(millis(30), millis(60), millis(90));
        assertThat(run.elapsed()).isEqualTo(millis(100));
        assertThat(run.instant()).isEqualTo(Instant.EPOCH.plusMillis(100));
    }

    @Test
    void runsNothingOfWhatItHadWhenThatIsDropped() {
        var ran = new ArrayList<String>();
        run.every(millis(10), () -> ran.add("a beat"));
        run.after(millis(20), () -> ran.add("a timer"));
        run.execute(() -> ran.add("a task"));
        run.compute(() -> ran.add("work"));
        run.drop();
        run.after(millis(50), () -> ran.add("a timer of afterwards"));
        run.advance(millis(100));
        assertThat(ran).containsExactly("a timer of afterwards");
    }

    @Test
    void advanceToNextGoesNoFartherThanAsked() {
        run.after(millis(50), () -> {});
        assertThat(run.advanceToNext(millis(20))).isFalse();
        assertThat(run.elapsed()).isEqualTo(millis(20));
        assertThat(run.advanceToNext(millis(100))).isTrue();
        assertThat(run.elapsed()).isEqualTo(millis(50));
    }

    @Test
    void aPausedRunStillHearsOthers() {
        var ran = new ArrayList<String>();
        run.after(Duration.ZERO, () -> ran.add("due"));
        run.execute(() -> ran.add("handed in"));
        run.runPending();
        assertThat(ran).containsExactly("handed in");
        assertThat(run.elapsed()).isZero();
    }

    @Test
    void theTaskThatThrewIsGoneAllOthersStay() {
        var ran = new ArrayList<String>();
        run.after(millis(10), () -> {
            throw new IllegalStateException("thrown by a task");
        });
        run.after(millis(10), () -> ran.add("same time"));
        run.every(millis(20), () -> ran.add("later"));
        assertThatIllegalStateException().isThrownBy(() -> run.advance(millis(50)));
        run.advance(millis(40));
        assertThat(ran).containsExactly("same time", "later", "later");
    }

    @Test
    void computationsEndEvenIfATaskAmongThemThrows() {
        var ended = new ArrayList<String>();
        run.compute(() -> "first").thenAccept(value -> {
            ended.add(value);
            run.execute(() -> {
                throw new IllegalStateException("thrown between two computations");
            });
        });
        run.compute(() -> "second").thenAccept(ended::add);
        assertThatIllegalStateException().isThrownBy(() -> run.advance(millis(10)));
        run.advance(millis(10));
        assertThat(ended).containsExactly("first", "second");
    }

    /// Tasks that make and cancel tasks, compared with a list that is searched for the first each time.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void runsByTimeThenPhaseThenOrder(long seed) {
        var real = new Play(new Random(seed), (nanos, phase, task) -> run.after(Duration.ofNanos(nanos), phase, task));
        var slow = new SlowScheduler();
        var expected = new Play(new Random(seed), slow::after);
        real.start();
        expected.start();
        run.advance(Duration.ofNanos(100));
        slow.advance(100);
        assertThat(real.ran).as("seed %d", seed).isEqualTo(expected.ran).hasSizeGreaterThan(50);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 8})
    void computationsEndInTheOrderTheyWereHandedInBeforeTheNextPhase(int workers) {
        try (var pool = Executors.newFixedThreadPool(workers)) {
            var many = new LockstepScheduler(Instant.EPOCH, pool);
            var ended = new ArrayList<String>();
            for (int i = 0; i < 50; i++) {
                int number = i;
                many.after(
                        millis(10),
                        Phase.DEVICES,
                        () -> many.compute(() -> work(50 - number)).thenAccept(_ -> ended.add("work " + number)));
            }
            many.after(millis(10), Phase.THINK, () -> ended.add("think"));
            many.advance(millis(10));
            var expected = new ArrayList<String>();
            for (int i = 0; i < 50; i++) {
                expected.add("work " + i);
            }
            expected.add("think");
            assertThat(ended).isEqualTo(expected);
        }
    }

    private static double work(int much) {
        double sum = 0;
        for (int i = 0; i < much * 1000; i++) {
            sum += Math.sqrt(i);
        }
        return sum;
    }

    private interface After {
        Task after(long nanos, Phase phase, Runnable task);
    }

    @Test
    void reportsWhatEachPhaseTakes() {
        var clock = new AtomicLong();
        var times = new PhaseTimes(clock::get, () -> 0);
        var timed = new LockstepScheduler(Instant.EPOCH, Runnable::run, times);
        timed.every(millis(10), Phase.WORLD, () -> clock.addAndGet(3));
        timed.every(millis(20), Phase.THINK, () -> {
            clock.addAndGet(50);
            timed.execute(() -> clock.addAndGet(7)); // part of the same phase
        });
        timed.every(millis(20), Phase.DEVICES, () -> timed.compute(() -> clock.addAndGet(400)));
        timed.advance(millis(25));
        clock.addAndGet(10_000); // between two steps, nobody's
        timed.advance(millis(15));
        assertThat(times.of(Phase.WORLD)).isEqualTo(Duration.ofNanos(4 * 3));
        assertThat(times.of(Phase.DEVICES)).isEqualTo(Duration.ofNanos(2 * 400));
        assertThat(times.of(Phase.THINK)).isEqualTo(Duration.ofNanos(2 * 57));
        assertThat(times.of(Phase.OBSERVE)).isZero();
    }

    /// One phase in 31 stands for all: over many steps that comes out right, also where 62 make a period.
    @ParameterizedTest
    @ValueSource(longs = {20, 1000})
    void reportsWhatEachPhaseTakesOfAProcessor(long thinkingPeriod) {
        var processor = new AtomicLong();
        var asked = new AtomicLong();
        var times = new PhaseTimes(() -> 0, () -> {
            asked.incrementAndGet();
            return processor.get();
        });
        var timed = new LockstepScheduler(Instant.EPOCH, Runnable::run, times);
        timed.every(millis(20), Phase.WORLD, () -> processor.addAndGet(300));
        timed.every(millis(100), Phase.DEVICES, () -> processor.addAndGet(100));
        timed.every(millis(thinkingPeriod), Phase.THINK, () -> processor.addAndGet(5_000));
        timed.every(millis(thinkingPeriod), Phase.OBSERVE, () -> {});
        for (int i = 0; i < 400_000; i++) {
            timed.advance(millis(20));
            processor.addAndGet(1_000_000); // between two steps, nobody's
        }
        long thoughts = 8_000_000 / thinkingPeriod;
        assertThat((double) times.processor(Phase.WORLD).toNanos()).isCloseTo(400_000 * 300.0, withinPercentage(20));
        assertThat((double) times.processor(Phase.DEVICES).toNanos()).isCloseTo(80_000 * 100.0, withinPercentage(20));
        assertThat((double) times.processor(Phase.THINK).toNanos()).isCloseTo(thoughts * 5_000.0, withinPercentage(20));
        assertThat(times.processor(Phase.OBSERVE)).isZero();
        assertThat(asked.get()).as("looks at the processor's clock").isLessThan(200_000);
    }

    /// A random play of tasks, the same on every scheduler that keeps the order.
    private static final class Play {
        private static final List<Phase> PHASES = List.of(Phase.values());

        private final Random random;
        private final After scheduler;
        private final List<Task> tasks = new ArrayList<>();
        private final List<Integer> ran = new ArrayList<>();

        Play(Random random, After scheduler) {
            this.random = random;
            this.scheduler = scheduler;
        }

        void start() {
            for (int i = 0; i < 60; i++) {
                add();
            }
        }

        private void add() {
            int number = tasks.size();
            Phase phase = PHASES.get(random.nextInt(PHASES.size()));
            tasks.add(scheduler.after(random.nextInt(20), phase, () -> {
                ran.add(number);
                if (random.nextInt(3) == 0) {
                    add();
                }
                if (random.nextInt(5) == 0) {
                    tasks.get(random.nextInt(tasks.size())).cancel();
                }
            }));
        }
    }

    private static final class SlowScheduler {
        private final List<Entry> entries = new ArrayList<>();
        private long now;
        private int order;

        private record Entry(long nanos, Phase phase, int order, Runnable task) {}

        Task after(long nanos, Phase phase, Runnable task) {
            var entry = new Entry(now + nanos, phase, order++, task);
            entries.add(entry);
            return () -> entries.remove(entry);
        }

        void advance(long until) {
            while (true) {
                var first = entries.stream()
                        .filter(e -> e.nanos <= until)
                        .min(Comparator.comparingLong(Entry::nanos)
                                .thenComparing(Entry::phase)
                                .thenComparingInt(Entry::order));
                if (first.isEmpty()) {
                    return;
                }
                entries.remove(first.get());
                now = first.get().nanos;
                first.get().task.run();
            }
        }
    }
}
