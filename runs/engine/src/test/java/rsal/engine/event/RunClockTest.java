package rsal.engine.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;

class RunClockTest {
    private Instant now = Instant.EPOCH.plusSeconds(100);
    private final RunClock clock = new RunClock(() -> now);

    @Test
    void standsAtNothingBeforeItIsStarted() {
        now = now.plusSeconds(7);
        assertThat(clock.elapsed()).isZero();
        assertThat(clock.at(now)).isZero();
        assertThat(clock.instant()).isEqualTo(now);
    }

    @Test
    void countsFromItsStart() {
        now = now.plusSeconds(7);
        clock.start();
        now = now.plusSeconds(2);
        assertThat(clock.elapsed()).isEqualTo(Duration.ofSeconds(2));
        assertThat(clock.at(now.minusSeconds(1))).isEqualTo(Duration.ofSeconds(1));
        assertThat(clock.at(now.minusSeconds(5))).as("before the start").isZero();
    }

    @Test
    void isStartedOnce() {
        clock.start();
        assertThatIllegalStateException().isThrownBy(clock::start);
    }
}
