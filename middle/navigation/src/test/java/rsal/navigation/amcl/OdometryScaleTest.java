package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

class OdometryScaleTest {
    private static final Covariance2d KNOWN = Covariance2d.ofDeviations(0.03, 0.03, 0.02);
    private static final double[] SEEN = {700, 0, 0, 700, 0, 3000, 0, 0, 0};
    private static final double[] CORRIDOR = {0, 0, 0, 1400, 0, 3000, 0, 0, 0}; // along x

    private final OdometryScale scale = new OdometryScale();
    private final SplittableRandom random = new SplittableRandom(1);
    private Pose2d truth = Pose2d.ORIGIN;

    private void go(int steps, Pose2d step, double distance, double turn, double[] sums) {
        for (int i = 0; i < steps; i++) {
            scale.move(new Pose2d(distance * step.x(), 0, turn * step.theta()), truth.theta());
            truth = truth.compose(step);
            var estimate = new Pose2d(
                    truth.x() + 0.02 * random.nextGaussian(), truth.y() + 0.02 * random.nextGaussian(), truth.theta());
            scale.shrink(KNOWN, sums);
            scale.see(estimate, KNOWN, true);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.8, 0.9, 1.1, 1.25})
    void findsByWhatFactorWaysAreWrong(double factor) {
        go(150, new Pose2d(0.1, 0, 0.01), factor, 1, SEEN);
        assertThat(scale.distanceFactor()).isCloseTo(1 / factor, within(0.03));
        assertThat(scale.corrected(new Pose2d(factor, 0, 0)).x()).isCloseTo(1, within(0.04));
        assertThat(scale.turnFactor()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.8, 1.25})
    void findsByWhatFactorTurnsAreWrong(double factor) {
        go(150, new Pose2d(0, 0, 0.1), 1, factor, SEEN);
        assertThat(scale.turnFactor()).isCloseTo(1 / factor, within(0.03));
        assertThat(scale.distanceFactor()).isEqualTo(1);
    }

    @Test
    void leavesWheelsAloneThatAreRight() {
        go(1000, new Pose2d(0.1, 0, 0.02), 1, 1, SEEN);
        assertThat(scale.isWrong()).isFalse();
        assertThat(scale.corrected(new Pose2d(0.1, 0, 0.02))).isEqualTo(new Pose2d(0.1, 0, 0.02));
    }

    /// A tenth of the way while nothing is known of the factor.
    @Test
    void theDriftGrowsWithTheWayAlongACorridor() {
        go(100, new Pose2d(0.1, 0, 0), 1, 1, CORRIDOR);
        assertThat(scale.drift()).isBetween(0.5, 1.01);
        double before = scale.drift();
        go(50, new Pose2d(0.1, 0, 0), 1, 1, CORRIDOR);
        assertThat(scale.drift()).isGreaterThan(before);
        go(20, new Pose2d(0.1, 0, 0), 1, 1, SEEN);
        assertThat(scale.drift()).as("where the end is seen").isLessThan(0.1);
    }
}
