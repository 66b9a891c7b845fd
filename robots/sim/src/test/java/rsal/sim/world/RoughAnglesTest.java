package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class RoughAnglesTest {
    @Test
    void areNotMoreWrongThanTheySay() {
        for (double angle = -Math.PI; angle <= Math.PI; angle += 1e-4) {
            double rough = RoughAngles.atan2(3 * Math.sin(angle), 3 * Math.cos(angle));
            assertThat(Math.IEEEremainder(rough - angle, 2 * Math.PI)).isCloseTo(0, within(RoughAngles.ERROR));
        }
        assertThat(RoughAngles.atan2(0, 0)).isZero();
        for (double q = 0; q <= 1; q += 1e-4) {
            assertThat(RoughAngles.asinAtLeast(q)).isGreaterThanOrEqualTo(Math.asin(q) - 1e-15);
        }
    }
}
