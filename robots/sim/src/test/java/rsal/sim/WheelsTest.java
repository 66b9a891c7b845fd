package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Twist2d;

class WheelsTest {
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 0.2, 1})
    void theWayMadeWhileSpeedingUpDoesNotDependOnTheStep(double dt) {
        var wheels = new Wheels(Models.DRIVE);
        double way = 0;
        double turned = 0;
        for (int i = 0; i < Math.round(4 / dt); i++) {
            wheels.spin(Twist2d.drive(0.7, 1), dt);
            way += wheels.distance();
            turned += wheels.turn();
        }
        assertThat(way).isCloseTo(0.7 * 4 - 0.7 * 0.7 / 0.5 / 2, within(1e-9)); // v t − v²/2a
        assertThat(turned).isCloseTo(1 * 4 - 1.0 / 3 / 2, within(1e-9));
    }

    @Test
    void neitherSpeedNorAccelerationPassesItsLimit() {
        var random = new SplittableRandom(4);
        var wheels = new Wheels(Models.DRIVE);
        Twist2d before = wheels.velocity();
        for (int i = 0; i < 5000; i++) {
            wheels.spin(Twist2d.drive(random.nextDouble(-5, 5), random.nextDouble(-9, 9)), 0.1);
            Twist2d now = wheels.velocity();
            assertThat(Math.abs(now.vx())).isLessThanOrEqualTo(0.8 + 1e-12);
            assertThat(Math.abs(now.omega())).isLessThanOrEqualTo(2 + 1e-12);
            assertThat(Math.abs(now.vx() - before.vx())).isLessThanOrEqualTo(0.05 + 1e-12);
            assertThat(Math.abs(now.omega() - before.omega())).isLessThanOrEqualTo(0.3 + 1e-12);
            before = now;
        }
    }

    @Test
    void standsStillWithoutACommand() {
        var wheels = new Wheels(Models.DRIVE);
        wheels.spin(Twist2d.STOP, 0.1);
        assertThat(wheels.velocity()).isEqualTo(Twist2d.STOP);
        assertThat(wheels.distance()).isZero();
    }
}
