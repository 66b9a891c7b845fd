package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;

/// Bins are 0.4 m and 20° wide: their middles are at 0.2 m, 0.6 m, …, and at 10°, 30°, ….
class ClustersTest {
    private final Particles particles = new Particles(5000);

    private void add(double x, double y, double degrees, double weight) {
        particles.add(x, y, Angles.wrap(Math.toRadians(degrees)));
        particles.weight[particles.count - 1] = weight;
    }

    private PoseEstimate estimate() {
        return new Clusters().estimate(particles);
    }

    @ParameterizedTest
    @CsvSource({
        "0.6, 0.2, 10, 1",
        "0.2, 0.6, 10, 1",
        "0.2, 0.2, 30, 1",
        "0.2, 0.2, -10, 1",
        "-0.2, -0.2, -10, 1", // by a corner of the bin
        "0.6, -0.2, 30, 1",
        "-0.2, 0.6, -10, 1",
        "1, 0.2, 10, 2", // one bin lies between
        "-0.6, 0.2, 10, 2",
        "0.2, 1, 10, 2",
        "0.2, -0.6, 10, 2",
        "0.2, 0.2, 50, 2",
        "0.2, 0.2, -30, 2"
    })
    void particlesInNeighboringBinsAreOneHypothesis(double x, double y, double degrees, int hypotheses) {
        add(0.2, 0.2, 10, 0.5);
        add(x, y, degrees, 0.5);
        assertThat(estimate().hypotheses()).hasSize(hypotheses);
    }

    @Test
    void headingsThatMeetBehindAreNeighbors() {
        add(0.2, 0.2, 170, 0.5);
        add(0.2, 0.2, -170, 0.5);
        assertThat(estimate().hypotheses()).hasSize(1);
    }

    @Test
    void aRowOfNeighborsIsOneHypothesisInWhateverOrderTheyCome() {
        int[] places = new SplittableRandom(5).ints(200, 0, 40).toArray();
        for (int place : places) {
            add(0.2 + 0.4 * place, 0.2, 10, 1.0 / places.length);
        }
        IntStream.range(0, 40).forEach(place -> add(0.2 + 0.4 * place, 0.2, 10, 0));
        assertThat(estimate().hypotheses()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aHypothesisHasTheMomentsOfItsParticles(long seed) {
        var random = new SplittableRandom(seed);
        double degrees = seed == 1 ? 180 : random.nextDouble(360); // where headings wrap around
        int count = 50 + random.nextInt(300);
        double sum = 0;
        for (int i = 0; i < count; i++) {
            double along = random.nextGaussian();
            double weight = random.nextDouble();
            sum += weight;
            add(
                    20 + 0.1 * along,
                    -7 + 0.05 * random.nextGaussian() - 0.1 * along,
                    degrees + 4 * random.nextGaussian() + 3 * along,
                    weight);
        }
        for (int i = 0; i < count; i++) {
            particles.weight[i] /= sum;
        }
        double[] mean = moments(i -> particles.x[i], i -> particles.y[i], i -> turn(degrees, i));
        Hypothesis hypothesis = estimate().hypotheses().getFirst();
        assertThat(hypothesis.weight()).isCloseTo(1, within(1e-12)).isLessThanOrEqualTo(1);
        Pose2d pose = hypothesis.mapFromBase();
        assertThat(pose.x()).isCloseTo(mean[0], within(1e-9));
        assertThat(pose.y()).isCloseTo(mean[1], within(1e-9));
        assertThat(Angles.difference(Math.toRadians(degrees), pose.theta())).isCloseTo(mean[2], within(1e-9));
        Of x = i -> particles.x[i] - mean[0];
        Of y = i -> particles.y[i] - mean[1];
        Of turn = i -> turn(degrees, i) - mean[2];
        double[] ofX = moments(i -> x.of(i) * x.of(i), i -> x.of(i) * y.of(i), i -> x.of(i) * turn.of(i));
        double[] others = moments(i -> y.of(i) * y.of(i), i -> y.of(i) * turn.of(i), i -> turn.of(i) * turn.of(i));
        Covariance2d covariance = hypothesis.covariance();
        assertThat(covariance.xx()).isCloseTo(ofX[0], within(1e-9));
        assertThat(covariance.xy()).isCloseTo(ofX[1], within(1e-9));
        assertThat(covariance.xTheta()).isCloseTo(ofX[2], within(1e-9));
        assertThat(covariance.yy()).isCloseTo(others[0], within(1e-9));
        assertThat(covariance.yTheta()).isCloseTo(others[1], within(1e-9));
        assertThat(covariance.thetaTheta()).isCloseTo(others[2], within(1e-9));
    }

    /// Of a particle.
    private interface Of {
        double of(int particle);
    }

    private double turn(double degrees, int particle) {
        return Angles.difference(Math.toRadians(degrees), particles.theta[particle]);
    }

    /// Weighted means.
    private double[] moments(Of... numbers) {
        var means = new double[numbers.length];
        for (int n = 0; n < numbers.length; n++) {
            for (int i = 0; i < particles.count; i++) {
                means[n] += particles.weight[i] * numbers[n].of(i);
            }
        }
        return means;
    }

    @Test
    void theTenHeaviestHypothesesAreKept() {
        for (int place = 0; place < 12; place++) {
            add(0.2 + 4 * place, 0.2, 10, (place + 1) / 78.0);
        }
        PoseEstimate estimate = estimate();
        assertThat(estimate.hypotheses()).hasSize(10);
        for (int i = 0; i < 10; i++) {
            Hypothesis hypothesis = estimate.hypotheses().get(i);
            assertThat(hypothesis.weight()).isCloseTo((12 - i) / 78.0, within(1e-12));
            assertThat(hypothesis.mapFromBase().x()).isCloseTo(0.2 + 4 * (11 - i), within(1e-9));
        }
        assertThat(estimate.mapFromBase())
                .isEqualTo(estimate.hypotheses().getFirst().mapFromBase());
        assertThat(estimate.covariance())
                .isEqualTo(estimate.hypotheses().getFirst().covariance());
        assertThat(estimate.confidence()).isCloseTo(12 / 78.0, within(1e-12));
        assertThat(estimate.quality()).isEqualTo(Quality.AMBIGUOUS);
    }

    @Test
    void whatHasNoWeightIsNoHypothesis() {
        add(0.2, 0.2, 10, 1);
        add(8.2, 0.2, 10, 0);
        assertThat(estimate().hypotheses()).hasSize(1);
    }

    @Test
    void isUsedAgainForMoreAndForFewer() {
        var clusters = new Clusters();
        for (int count : new int[] {3, 700, 3000, 20, 1}) {
            particles.count = 0;
            var random = new SplittableRandom(count);
            for (int i = 0; i < count; i++) {
                add(random.nextDouble(30), random.nextDouble(30), random.nextDouble(360), 1.0 / count);
            }
            assertThat(clusters.estimate(particles)).as("%d particles", count).isEqualTo(estimate());
        }
    }
}
