package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.navigation.amcl.OdometryModel.Base;

class OdometryModelTest {
    private static final int COUNT = 20_000;
    private static final OdometryModel MODEL = new OdometryModel(0.1, 0.05, 0.2);
    private static final OdometryModel EXACT = new OdometryModel(0, 0, 0);

    @Test
    void withoutNoiseAllFollowTheOdometry() {
        Pose2d old = new Pose2d(1, 2, 0.5);
        for (Pose2d way : new Pose2d[] {
            new Pose2d(0.3, 0.1, 0.4), new Pose2d(-0.2, 0.05, -0.3), new Pose2d(0, 0, 3), new Pose2d(0, 0, 0)
        }) {
            Particles particles = at(new Pose2d(-3, 4, 2), 1);
            EXACT.move(old, old.compose(way), particles, new SplittableRandom(1));
            Pose2d expected = new Pose2d(-3, 4, 2).compose(way);
            assertThat(particles.x[0]).isCloseTo(expected.x(), within(1e-9));
            assertThat(particles.y[0]).isCloseTo(expected.y(), within(1e-9));
            assertThat(Angles.difference(particles.theta[0], expected.theta())).isCloseTo(0, within(1e-9));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, Double.NaN, Double.POSITIVE_INFINITY})
    void noiseIsFiniteAndNotBelowZero(double noise) {
        assertThatIllegalArgumentException().isThrownBy(() -> new OdometryModel(noise, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new OdometryModel(0, noise, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new OdometryModel(0, 0, noise));
        assertThatIllegalArgumentException().isThrownBy(() -> new OdometryModel(0, 0, 0, noise, Base.OMNIDIRECTIONAL));
    }

    @Test
    void errorsOfAStraightWayGrowWithItsRoot() {
        assertThat(deviationAlong(new Pose2d(1, 0, 0), 1)).isCloseTo(0.1, within(0.005));
        assertThat(deviationAlong(new Pose2d(4, 0, 0), 1)).isCloseTo(0.2, within(0.01));
        assertThat(deviationAlong(new Pose2d(-1, 0, 0), 1)).isCloseTo(0.1, within(0.005));
    }

    @Test
    void manyStepsAreAsUncertainAsOne() {
        assertThat(deviationAlong(new Pose2d(0.1, 0, 0), 10)).isCloseTo(0.1, within(0.005));
    }

    @Test
    void errorsOfATurnGrowWithItsRoot() {
        Particles particles = at(Pose2d.ORIGIN, COUNT);
        MODEL.move(Pose2d.ORIGIN, new Pose2d(0, 0, 2), particles, new SplittableRandom(3));
        double squares = 0;
        for (int i = 0; i < COUNT; i++) {
            double error = Angles.difference(2, particles.theta[i]);
            squares += error * error;
        }
        assertThat(Math.sqrt(squares / COUNT)).isCloseTo(0.2 * Math.sqrt(2), within(0.01));
    }

    @Test
    void anOmnidirectionalBaseSlidesAsOdometrySaysAndErrsAlongAndAcross() {
        var exact = new OdometryModel(0, 0, 0, 0, Base.OMNIDIRECTIONAL);
        Pose2d old = new Pose2d(1, 2, 0.5);
        for (Pose2d way : new Pose2d[] {new Pose2d(0, 0.4, 0), new Pose2d(-0.3, 0.1, 0.2), new Pose2d(0, 0, 1)}) {
            Pose2d found = exact.sample(new Pose2d(-3, 4, 2), old, old.compose(way), new SplittableRandom(1));
            Pose2d expected = new Pose2d(-3, 4, 2).compose(way);
            assertThat(found.distanceTo(expected)).isLessThan(1e-9);
            assertThat(Angles.difference(found.theta(), expected.theta())).isCloseTo(0, within(1e-9));
        }
        var erring = new OdometryModel(0.1, 0, 0, 0.05, Base.OMNIDIRECTIONAL);
        Particles particles = at(Pose2d.ORIGIN, COUNT);
        erring.move(Pose2d.ORIGIN, new Pose2d(0, 4, 0), particles, new SplittableRandom(4));
        double along = 0;
        double across = 0;
        for (int i = 0; i < COUNT; i++) {
            along += (particles.y[i] - 4) * (particles.y[i] - 4);
            across += particles.x[i] * particles.x[i];
            assertThat(particles.theta[i]).isZero();
        }
        assertThat(Math.sqrt(along / COUNT)).isCloseTo(0.2, within(0.01));
        assertThat(Math.sqrt(across / COUNT)).isCloseTo(0.1, within(0.005));
    }

    /// A turn t1, a way L and a turn t2 have turns with variances v1 = α2² L/2 + α1² |t1|, and v2 of t2. The
    /// heading then has the variance v1 + v2. What is across the way has L² v1 (of small errors), and both
    /// covary by L v1.
    @Test
    void eachTurnErrsByItsOwnAngle() {
        for (double[] turns : new double[][] {{1.2, -0.2}, {-0.2, 1.2}, {0.1, 0.1}, {-1.4, 0.9}}) {
            double length = 0.5;
            Pose2d way =
                    new Pose2d(0, 0, turns[0]).compose(new Pose2d(length, 0, 0)).compose(new Pose2d(0, 0, turns[1]));
            var model = new OdometryModel(0, 0.03, 0.05);
            Particles particles = at(Pose2d.ORIGIN, COUNT);
            model.move(Pose2d.ORIGIN, way, particles, new SplittableRandom(6));
            double first = 0.03 * 0.03 * length / 2 + 0.05 * 0.05 * Math.abs(turns[0]);
            double second = 0.03 * 0.03 * length / 2 + 0.05 * 0.05 * Math.abs(turns[1]);
            double heading = 0;
            double across = 0;
            double both = 0;
            for (int i = 0; i < COUNT; i++) {
                double wrong = Angles.difference(way.theta(), particles.theta[i]);
                double aside = Math.cos(turns[0]) * particles.y[i] - Math.sin(turns[0]) * particles.x[i];
                heading += wrong * wrong / COUNT;
                across += aside * aside / COUNT;
                both += aside * wrong / COUNT;
            }
            assertThat(heading).isCloseTo(first + second, within(0.06 * (first + second)));
            assertThat(across).isCloseTo(length * length * first, within(0.06 * length * length * first));
            assertThat(both).isCloseTo(length * first, within(0.08 * length * (first + second)));
        }
    }

    /// It turned wrong on its way: of a heading's error half counts for the direction of the way.
    @Test
    void anOmnidirectionalBaseGoesAsideByHalfOfItsHeadingsError() {
        var model = new OdometryModel(0, 0.05, 0.1, 0, Base.OMNIDIRECTIONAL);
        for (double bearing : new double[] {0, 1, -2}) {
            var way = new Pose2d(2 * Math.cos(bearing), 2 * Math.sin(bearing), 0.4);
            Particles particles = at(Pose2d.ORIGIN, COUNT);
            model.move(Pose2d.ORIGIN, way, particles, new SplittableRandom(7));
            double variance = 0.05 * 0.05 * 2 + 0.1 * 0.1 * 0.4;
            double heading = 0;
            double both = 0;
            for (int i = 0; i < COUNT; i++) {
                double wrong = Angles.difference(0.4, particles.theta[i]);
                double aside = Math.cos(bearing) * particles.y[i] - Math.sin(bearing) * particles.x[i];
                heading += wrong * wrong / COUNT;
                both += aside * wrong / COUNT;
            }
            assertThat(heading).isCloseTo(variance, within(0.05 * variance));
            assertThat(both).isCloseTo(2 * variance / 2, within(0.06 * variance));
        }
    }

    private static double deviationAlong(Pose2d step, int steps) {
        Particles particles = at(Pose2d.ORIGIN, COUNT);
        var random = new SplittableRandom(2);
        var noTurns = new OdometryModel(MODEL.distancePerMeter(), 0, 0);
        Pose2d from = Pose2d.ORIGIN;
        for (int i = 0; i < steps; i++) {
            Pose2d to = from.compose(step);
            noTurns.move(from, to, particles, random);
            from = to;
        }
        double squares = 0;
        for (int i = 0; i < COUNT; i++) {
            squares += (particles.x[i] - from.x()) * (particles.x[i] - from.x());
        }
        return Math.sqrt(squares / COUNT);
    }

    private static Particles at(Pose2d pose, int count) {
        var particles = new Particles(count);
        for (int i = 0; i < count; i++) {
            particles.add(pose.x(), pose.y(), pose.theta());
        }
        particles.weighEqually();
        return particles;
    }

    /// Gaussian numbers as they are given, one after the other.
    private static RandomGenerator gaussians(double... numbers) {
        return new RandomGenerator() {
            private int next;

            @Override
            public double nextGaussian() {
                return numbers[next++];
            }

            @Override
            public long nextLong() {
                throw new IllegalStateException("Only Gaussian numbers are asked for.");
            }
        };
    }

    /// Probabilistic Robotics, table 5.6, with noise that grows with the root of way and angle.
    @Test
    void aWayIsATurnADriveAndATurnEachWithAnErrorOfItsOwn() {
        var model = new OdometryModel(0.1, 0.2, 0.3);
        Pose2d way = new Pose2d(0, 0, 0.5).compose(new Pose2d(2, 0, 0)).compose(new Pose2d(0, 0, -0.2));
        double half = 0.2 * 0.2 * 2 / 2;
        double first = 0.5 + 1.1 * Math.sqrt(half + 0.3 * 0.3 * 0.5);
        double made = 2 - 0.7 * 0.1 * Math.sqrt(2);
        double second = -0.2 + 0.4 * Math.sqrt(half + 0.3 * 0.3 * 0.2);
        Pose2d start = new Pose2d(1, -2, 0.7);
        Pose2d expected = start.compose(new Pose2d(0, 0, first))
                .compose(new Pose2d(made, 0, 0))
                .compose(new Pose2d(0, 0, second));
        Pose2d found = model.sample(start, Pose2d.ORIGIN, way, gaussians(1.1, -0.7, 0.4));
        assertThat(found.isNear(expected, 1e-9, 1e-9)).isTrue();
    }

    @Test
    void aWayOfAnOmnidirectionalBaseErrsAlongAcrossAndInItsTurn() {
        var model = new OdometryModel(0.1, 0.2, 0.3, 0.05, Base.OMNIDIRECTIONAL);
        double bearing = -2;
        var way = new Pose2d(2 * Math.cos(bearing), 2 * Math.sin(bearing), 0.4);
        double along = 2 + 1.1 * 0.1 * Math.sqrt(2);
        double across = -0.7 * 0.05 * Math.sqrt(2);
        double wrong = 0.4 * Math.sqrt(0.2 * 0.2 * 2 + 0.3 * 0.3 * 0.4);
        Pose2d start = new Pose2d(1, -2, 0.7);
        Pose2d slid = start.compose(new Pose2d(0, 0, bearing + wrong / 2)).compose(new Pose2d(along, across, 0));
        Pose2d found = model.sample(start, Pose2d.ORIGIN, way, gaussians(1.1, -0.7, 0.4));
        assertThat(found.isNear(new Pose2d(slid.x(), slid.y(), 0.7 + 0.4 + wrong), 1e-9, 1e-9))
                .isTrue();
    }

    @Test
    void whoDrivesBackwardsDoesNotTurnAround() {
        var turning = new OdometryModel(0, 0, 0.3);
        Pose2d found = turning.sample(Pose2d.ORIGIN, Pose2d.ORIGIN, new Pose2d(-1, 0, 0), gaussians(1, 1, 1));
        assertThat(found.isNear(new Pose2d(-1, 0, 0), 1e-9, 1e-9)).isTrue();
    }

    /// Less than a millimeter has no direction: half of the turn is before it, half after.
    @Test
    void onTheSpotTheTurnIsHalvedAndItsErrorsAreThoseOfBothHalves() {
        var turning = new OdometryModel(0, 0, 0.3);
        Pose2d found = turning.sample(Pose2d.ORIGIN, Pose2d.ORIGIN, new Pose2d(0, 0.0009, 1.2), gaussians(1, 0, -0.5));
        double each = Math.sqrt(0.3 * 0.3 * 0.6);
        assertThat(found.theta()).isCloseTo(1.2 + each - 0.5 * each, within(1e-9));
        Pose2d far = turning.sample(Pose2d.ORIGIN, Pose2d.ORIGIN, new Pose2d(0, 0.001, 1.2), gaussians(1, 0, 0));
        assertThat(far.theta())
                .as("of the turn to the way")
                .isCloseTo(1.2 + 0.3 * Math.sqrt(Math.PI / 2), within(1e-9));
    }

    /// A way of length L and a turn of t: σ² = (δ² + σ²) L + α² L³/3 in position, α² L + τ² |t| in heading.
    @Test
    void uncertaintyGrowsWithTheWayAndTheTurn() {
        var model = new OdometryModel(0.1, 0.2, 0.3, 0.05, Base.OMNIDIRECTIONAL);
        Covariance2d grown = model.covariance(new Pose2d(3, -4, -0.5));
        double position = 0.1 * 0.1 * 5 + 0.05 * 0.05 * 5 + 0.2 * 0.2 * 125 / 3;
        assertThat(grown.xx()).isCloseTo(position, within(1e-12));
        assertThat(grown.yy()).isCloseTo(position, within(1e-12));
        assertThat(grown.xy()).isZero();
        assertThat(grown.thetaTheta()).isCloseTo(0.2 * 0.2 * 5 + 0.3 * 0.3 * 0.5, within(1e-12));
    }
}
