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

    @Test
    void itsInverseUndoesIt() {
        var covariance = new Covariance2d(2, 0.3, -0.2, 1.5, 0.4, 0.7);

        assertNear(covariance.inverse().inverse(), covariance);
        assertNear(Covariance2d.ofDeviations(2, 4, 0.5).inverse(), Covariance2d.ofDeviations(0.5, 0.25, 2));
        assertThat(Covariance2d.ofDeviations(1, 0, 1).inverse().isFinite()).isFalse();
    }

    @Test
    void addsUpAndScales() {
        var covariance = new Covariance2d(2, 0.3, -0.2, 1.5, 0.4, 0.7);

        assertNear(covariance.plus(covariance), covariance.times(2));
    }

    @Test
    void turnsWithItsAxes() {
        var ahead = new Covariance2d(4, 0, 0.5, 1, 0, 0.1);

        assertNear(ahead.turned(Math.PI / 2), new Covariance2d(1, 0, 0, 4, 0.5, 0.1));
        assertNear(ahead.turned(0.7).turned(-0.7), ahead);
        assertThat(ahead.turned(0.3).positionDeviation()).isCloseTo(2, within(1e-9));
    }

    private static void assertNear(Covariance2d is, Covariance2d expected) {
        assertThat(new double[] {is.xx(), is.xy(), is.xTheta(), is.yy(), is.yTheta(), is.thetaTheta()})
                .containsExactly(
                        new double[] {
                            expected.xx(),
                            expected.xy(),
                            expected.xTheta(),
                            expected.yy(),
                            expected.yTheta(),
                            expected.thetaTheta()
                        },
                        within(1e-9));
    }
}
