package rsal.engine.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.concurrent.CompletionException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import rsal.engine.report.RunBroken;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;

class GuardedSchedulerTest {
    private final LockstepScheduler time = new LockstepScheduler();
    private final GuardedScheduler guarded = new GuardedScheduler("Device 'lamp'", time);

    @Test
    void isOfTheRunOfThoseThatItGuards() {
        assertThat(guarded.run()).isEqualTo(new GuardedScheduler("Device 'horn'", time).run());
        assertThat(guarded.run()).isNotEqualTo(new LockstepScheduler().run());
    }

    @Test
    void reportsWhoseTaskFailed() {
        guarded.after(Duration.ZERO, Phase.DEVICES, () -> {
            throw new IllegalStateException("it went out");
        });
        assertThatThrownBy(() -> time.advance(Duration.ZERO))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Device 'lamp' failed: it went out");
    }

    @Test
    void runsNothingOfWhatCouldNotBeMade() {
        var shone = new AtomicInteger();
        assertThatThrownBy(() -> guarded.making(() -> {
                    guarded.every(Duration.ofSeconds(1), Phase.DEVICES, shone::incrementAndGet);
                    guarded.after(Duration.ofSeconds(1), Phase.DEVICES, shone::incrementAndGet);
                    guarded.execute(shone::incrementAndGet);
                    throw new IllegalStateException("no bulb");
                }))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Device 'lamp' failed: no bulb");
        time.advance(Duration.ofSeconds(3));
        assertThat(shone).hasValue(0);
    }

    @Test
    void reportsWhoOverwhelmedTheMachine() {
        guarded.execute(() -> {
            throw new StackOverflowError();
        });
        assertThatThrownBy(() -> time.advance(Duration.ZERO))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Device 'lamp' failed: StackOverflowError");
    }

    @Test
    void reportsALackOfMemoryWhereverItWas() {
        var lack = new OutOfMemoryError("Java heap space");
        guarded.execute(() -> {
            throw new IllegalStateException("the rays", new CompletionException(lack));
        });
        assertThatThrownBy(() -> time.advance(Duration.ZERO))
                .satisfies(broken -> assertThat(RunBroken.lackOfMemory(broken)).containsSame(lack));
        assertThat(RunBroken.lackOfMemory(new RunBroken("The lamp", new IllegalStateException("no bulb"))))
                .isEmpty();
    }
}
