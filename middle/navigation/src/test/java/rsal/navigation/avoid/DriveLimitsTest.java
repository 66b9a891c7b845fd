package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class DriveLimitsTest {
    /// v²/(2 a/2) = s: it comes to rest within the distance by half of what braking can do.
    @Test
    void arrivesByHalfOfWhatBrakingCanDo() {
        for (double acceleration : new double[] {0.2, 1, 3}) {
            var limits = new DriveLimits(1, 1, acceleration, 1);
            for (double distance : new double[] {0, 0.1, 0.5, 2}) {
                double speed = limits.arriving(distance);
                assertThat(speed * speed / (2 * (acceleration / 2))).isCloseTo(distance, within(1e-12));
            }
        }
    }

    @Test
    void allOfThemArePositive() {
        for (double wrong : new double[] {0, -1, Double.NaN}) {
            assertThatIllegalArgumentException().isThrownBy(() -> new DriveLimits(wrong, 1, 1, 1));
            assertThatIllegalArgumentException().isThrownBy(() -> new DriveLimits(1, wrong, 1, 1));
            assertThatIllegalArgumentException().isThrownBy(() -> new DriveLimits(1, 1, wrong, 1));
            assertThatIllegalArgumentException().isThrownBy(() -> new DriveLimits(1, 1, 1, wrong));
        }
    }
}
