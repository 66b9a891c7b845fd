package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class Covariance2dTest {
    @Test
    void thePositionDeviatesMostAlongTheLongAxisHoweverItLies() {
        for (int degrees = 0; degrees < 180; degrees += 15) {
            double cos = Math.cos(Math.toRadians(degrees));
            double sin = Math.sin(Math.toRadians(degrees));
            double along = 0.3 * 0.3;
            double across = 0.1 * 0.1;
            var turned = new Covariance2d(
                    along * cos * cos + across * sin * sin,
                    (along - across) * cos * sin,
                    0,
                    along * sin * sin + across * cos * cos,
                    0,
                    1);
            assertThat(turned.positionDeviation()).as("%d°", degrees).isCloseTo(0.3, within(1e-12));
        }
    }

    @Test
    void rewritesDeviationsAsVariances() {
        assertThat(Covariance2d.ofDeviations(1, 2, 3)).isEqualTo(new Covariance2d(1, 0, 0, 4, 0, 9));
    }
}
