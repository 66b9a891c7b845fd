package rsal.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class RunRateTest {
    private final RunRate rate = new RunRate();

    @Test
    void isThatOfTheLastHalfSecond() {
        reach(0, 10, false);
        reach(10, 10.25, false);
        assertThat(rate.value()).isZero(); // too soon to tell
        reach(20, 10.5, false);
        assertThat(rate.value()).isEqualTo(40);
        reach(40, 11.5, false);
        assertThat(rate.value()).isEqualTo(20);
    }

    @Test
    void aPauseDoesNotCount() {
        reach(0, 1, false);
        reach(10, 2, false);
        reach(10, 3, true);
        assertThat(rate.value()).isZero();
        reach(10, 60, true);
        reach(11, 61, false);
        reach(13, 62, false);
        assertThat(rate.value()).isEqualTo(2);
    }

    private void reach(double simulated, double real, boolean paused) {
        rate.reach(Duration.ofMillis(Math.round(simulated * 1e3)), Math.round(real * 1e9), paused);
    }
}
