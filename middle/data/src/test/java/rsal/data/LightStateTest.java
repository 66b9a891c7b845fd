package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.LightState.Signal;

class LightStateTest {
    @Test
    void shinesForItsShareOfEachPeriod() {
        for (long seed = 0; seed < 100; seed++) {
            var random = new Random(seed);
            var signal = new Signal(Duration.ofMillis(1 + random.nextInt(3000)), random.nextDouble());
            int lit = 0;
            Duration step = signal.period().dividedBy(1000);
            for (int i = 0; i < 5000; i++) {
                lit += signal.litAfter(step.multipliedBy(i)) ? 1 : 0;
            }
            assertThat(lit / 5000.0).as("seed %d", seed).isCloseTo(signal.dutyCycle(), within(0.01));
        }
    }

    @Test
    void onIsAlwaysLitAndOffNever() {
        for (int i = 0; i < 50; i++) {
            assertThat(Signal.ON.litAfter(Duration.ofMillis(97L * i))).isTrue();
            assertThat(Signal.OFF.litAfter(Duration.ofMillis(97L * i))).isFalse();
        }
    }

    @Test
    void refusesWhatIsNoSignal() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Signal(Duration.ZERO, 0.5));
        assertThatIllegalArgumentException().isThrownBy(() -> new Signal(Duration.ofSeconds(1), 1.1));
        assertThatIllegalArgumentException().isThrownBy(() -> new Signal(Duration.ofSeconds(1), Double.NaN));
    }
}
