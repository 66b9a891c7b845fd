package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Interval;
import rsal.data.Twist2d;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Steering;

class WheelSpeedsTest {
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 0.2, 1})
    void theWayMadeWhileSpeedingUpDoesNotDependOnTheStep(double dt) {
        var wheels = new WheelSpeeds(Models.DRIVE);
        double distance = 0;
        double turned = 0;
        for (int i = 0; i < Math.round(4 / dt); i++) {
            wheels.spin(Twist2d.drive(0.7, 1), dt);
            distance += wheels.forward();
            turned += wheels.turn();
        }
        assertThat(distance).isCloseTo(0.7 * 4 - 0.7 * 0.7 / 0.5 / 2, within(1e-9)); // v t − v²/2a
        assertThat(turned).isCloseTo(1 * 4 - 1.0 / 3 / 2, within(1e-9));
    }

    @Test
    void neitherSpeedNorAccelerationPassesItsLimit() {
        var random = new SplittableRandom(4);
        var wheels = new WheelSpeeds(Models.DRIVE);
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
        var wheels = new WheelSpeeds(Models.DRIVE);
        wheels.spin(Twist2d.STOP, 0.1);
        assertThat(wheels.velocity()).isEqualTo(Twist2d.STOP);
        assertThat(wheels.forward()).isZero();
    }

    private static Drive drive(Steering steering) {
        return new Drive(
                steering,
                new Axis(new Interval(-0.2, 0.8), new Interval(-2, 0.5)),
                steering instanceof Steering.Omnidirectional
                        ? new Axis(new Interval(-0.3, 0.5), new Interval(-1, 0.7))
                        : Axis.NONE,
                new Axis(new Interval(-1, 2), new Interval(-3, 4)),
                Models.NO_NOISE);
    }

    static List<Steering> steerings() {
        return List.of(new Steering.Differential(), new Steering.Omnidirectional(), new Steering.Car(0.3, 0.5));
    }

    @ParameterizedTest
    @MethodSource("steerings")
    void noSpeedPassesItsOwnLimitOnEitherSide(Steering steering) {
        Drive drive = drive(steering);
        var random = new SplittableRandom(4);
        var wheels = new WheelSpeeds(drive);
        Twist2d before = wheels.velocity();
        for (int i = 0; i < 5000; i++) {
            var wanted = new Twist2d(random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(-9, 9));
            wheels.spin(wanted, 0.1);
            Twist2d now = wheels.velocity();
            assertWithin(drive.forward(), before.vx(), now.vx());
            assertWithin(drive.sideways(), before.vy(), now.vy());
            assertThat(now.omega()).isBetween(-1 - 1e-12, 2 + 1e-12);
            if (steering instanceof Steering.Car car) {
                assertThat(Math.abs(now.omega()) * car.turningRadius()).isLessThanOrEqualTo(Math.abs(now.vx()) + 1e-12);
                assertThat(Math.abs(wheels.turn()) * car.turningRadius())
                        .isLessThanOrEqualTo(Math.abs(wheels.forward()) + 1e-12);
            } else {
                assertWithin(drive.turn(), before.omega(), now.omega());
            }
            before = now;
        }
    }

    private static void assertWithin(Axis axis, double before, double now) {
        assertThat(now).isBetween(axis.speed().least() - 1e-12, axis.speed().most() + 1e-12);
        assertThat(now - before)
                .isBetween(
                        axis.acceleration().least() * 0.1 - 1e-12,
                        axis.acceleration().most() * 0.1 + 1e-12);
    }

    /// Against an integration in a thousand little steps.
    @Test
    void theWayIsTheIntegralOfTheSpeeds() {
        Drive drive = drive(new Steering.Omnidirectional());
        var random = new SplittableRandom(8);
        var wheels = new WheelSpeeds(drive);
        var slow = new WheelSpeeds(drive);
        for (int i = 0; i < 100; i++) {
            var wanted =
                    new Twist2d(random.nextDouble(-0.2, 0.8), random.nextDouble(-0.3, 0.5), random.nextDouble(-1, 2));
            wheels.spin(wanted, 0.2);
            double forward = 0;
            double left = 0;
            double turn = 0;
            for (int k = 0; k < 1000; k++) {
                Twist2d before = slow.velocity();
                slow.spin(wanted, 0.0002);
                forward += (before.vx() + slow.velocity().vx()) * 0.0001;
                left += (before.vy() + slow.velocity().vy()) * 0.0001;
                turn += (before.omega() + slow.velocity().omega()) * 0.0001;
            }
            assertThat(wheels.forward()).isCloseTo(forward, within(1e-6));
            assertThat(wheels.left()).isCloseTo(left, within(1e-6));
            assertThat(wheels.turn()).isCloseTo(turn, within(1e-6));
        }
    }
}
