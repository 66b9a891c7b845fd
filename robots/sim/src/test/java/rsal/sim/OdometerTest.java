package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.robot.RobotModel.OdometryNoise;

class OdometerTest {
    private static final OdometryNoise NOISE = new OdometryNoise(0.03, 0.02, 0.05);

    @ParameterizedTest
    @ValueSource(ints = {1, 10, 200})
    void driftGrowsWithTheWayWhateverTheStep(int steps) {
        assertThat(deviation(4, 0, steps, Pose2d::theta)).isCloseTo(0.02 * 2, within(0.002));
        assertThat(deviation(4, 0, steps, p -> Math.hypot(p.x(), p.y()) - 4)).isCloseTo(0.03 * 2, within(0.003));
        assertThat(deviation(0, 2, steps, p -> p.theta() - 2)).isCloseTo(0.05 * Math.sqrt(2), within(0.003));
    }

    private static double deviation(double distance, double turn, int steps, ToDoubleFunction<Pose2d> error) {
        var random = new SplittableRandom(9);
        double sum = 0;
        int runs = 2000;
        for (int run = 0; run < runs; run++) {
            var odometer = new Odometer(NOISE, 1, random);
            for (int step = 0; step < steps; step++) {
                odometer.moved(distance / steps, 0, turn / steps);
            }
            double e = error.applyAsDouble(odometer.odomFromBase());
            sum += e * e;
        }
        return Math.sqrt(sum / runs);
    }

    @Test
    void standingStillDoesNotDrift() {
        var odometer = new Odometer(NOISE, 1, new SplittableRandom(1));
        odometer.moved(0, 0, 0);
        assertThat(odometer.odomFromBase()).isEqualTo(Pose2d.ORIGIN);
    }

    @Test
    void withoutNoiseItIsPerfect() {
        var odometer = new Odometer(NOISE, 0, new SplittableRandom(1));
        odometer.moved(1, 0, 0);
        odometer.moved(0, 0, Math.PI / 2);
        odometer.moved(2, 0, 0);
        assertThat(odometer.odomFromBase().isNear(new Pose2d(1, 2, Math.PI / 2), 1e-12, 1e-12))
                .isTrue();
    }

    @Test
    void sidewaysWaysDriftAlongThemselves() {
        var random = new SplittableRandom(3);
        double sum = 0;
        int runs = 2000;
        for (int run = 0; run < runs; run++) {
            var odometer = new Odometer(new OdometryNoise(0.03, 0, 0), 1, random);
            odometer.moved(-3, 4, 0);
            Pose2d there = odometer.odomFromBase();
            assertThat(there.y()).isCloseTo(there.x() * 4 / -3, within(1e-9));
            sum += Math.pow(Math.hypot(there.x(), there.y()) - 5, 2);
        }
        assertThat(Math.sqrt(sum / runs)).isCloseTo(0.03 * Math.sqrt(5), within(0.003));
    }
}
