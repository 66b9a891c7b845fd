package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;

class GuardedSchedulerTest {
    private final LockstepScheduler time = new LockstepScheduler();
    private final GuardedScheduler guarded = new GuardedScheduler("Device (lamp)", time);

    @Test
    void tellsWhoseTaskFailed() {
        guarded.after(Duration.ZERO, Phase.DEVICES, () -> {
            throw new IllegalStateException("it went out");
        });
        assertThatThrownBy(() -> time.advance(Duration.ZERO))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Device (lamp) failed: it went out");
    }

    @Test
    void tellsWhoOverwhelmedTheMachine() {
        guarded.execute(() -> {
            throw new StackOverflowError();
        });
        assertThatThrownBy(() -> time.advance(Duration.ZERO))
                .isInstanceOf(RunBroken.class)
                .hasMessage("Device (lamp) failed: StackOverflowError");
    }
}
