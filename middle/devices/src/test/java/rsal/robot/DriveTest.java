package rsal.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.Interval;
import rsal.data.Twist2d;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Steering;

class DriveTest {
    private static final OdometryNoise NONE = new OdometryNoise(0, 0, 0);

    @Test
    void whatIsPossibleIsNotTouched() {
        Drive drive = new Drive(1, 2, 1, 1, NONE);
        assertThat(drive.feasible(Twist2d.drive(1, -2))).isEqualTo(Twist2d.drive(1, -2));
        assertThat(drive.feasible(Twist2d.STOP)).isEqualTo(Twist2d.STOP);
        assertThat(drive.feasible(new Twist2d(-0.0, -0.0, -0.0))).isEqualTo(Twist2d.STOP);
    }

    @Test
    void everyWishIsCutToWhatTheDriveCan() {
        for (long seed = 0; seed < 2000; seed++) {
            var random = new Random(seed);
            Drive drive = any(random);
            Twist2d wanted = new Twist2d(wish(random), wish(random), wish(random));
            Twist2d given = drive.feasible(wanted);
            assertThat(drive.forward().speed().contains(given.vx() * (1 - 1e-12)))
                    .as("seed %d", seed)
                    .isTrue();
            assertThat(drive.sideways().speed().contains(given.vy() * (1 - 1e-12)))
                    .as("seed %d", seed)
                    .isTrue();
            assertThat(drive.turn().speed().contains(given.omega() * (1 - 1e-12)))
                    .as("seed %d", seed)
                    .isTrue();
            Twist2d again = drive.feasible(given);
            assertThat(again.vx()).as("seed %d", seed).isCloseTo(given.vx(), within(1e-9));
            assertThat(again.omega()).as("seed %d", seed).isCloseTo(given.omega(), within(1e-9));
            assertKeepsItsCurvature(seed, drive.steering(), wanted, given);
        }
    }

    private static void assertKeepsItsCurvature(long seed, Steering steering, Twist2d wanted, Twist2d given) {
        double crossed = given.vx() * wanted.omega() - given.omega() * wanted.vx();
        switch (steering) {
            case Steering.Differential _ -> {
                assertThat(given.vy()).as("seed %d", seed).isZero();
                assertThat(crossed).as("seed %d", seed).isCloseTo(0, within(1e-9));
            }
            case Steering.Omnidirectional _ -> {
                assertThat(crossed).as("seed %d", seed).isCloseTo(0, within(1e-9));
                assertThat(given.vx() * wanted.vy())
                        .as("seed %d", seed)
                        .isCloseTo(given.vy() * wanted.vx(), within(1e-9));
            }
            case Steering.Car car -> {
                assertThat(given.vy()).as("seed %d", seed).isZero();
                assertThat(Math.abs(given.omega()) * car.turningRadius())
                        .as("seed %d", seed)
                        .isLessThanOrEqualTo(Math.abs(given.vx()) + 1e-9);
                assertThat(given.omega() * wanted.omega()).as("seed %d", seed).isGreaterThanOrEqualTo(0);
            }
        }
    }

    private static Drive any(Random random) {
        Steering steering = switch (random.nextInt(3)) {
            case 0 -> new Steering.Differential();
            case 1 -> new Steering.Omnidirectional();
            default -> new Steering.Car(0.1 + random.nextDouble(), 0.1 + random.nextDouble());
        };
        Axis sideways = steering instanceof Steering.Omnidirectional ? axis(random) : Axis.NONE;
        return new Drive(steering, axis(random), sideways, axis(random), NONE);
    }

    private static Axis axis(Random random) {
        double least = random.nextInt(4) == 0 ? 0 : -random.nextDouble();
        return new Axis(new Interval(least, 0.01 + random.nextDouble()), Interval.around0(1));
    }

    private static double wish(Random random) {
        return random.nextInt(4) == 0 ? 0 : 3 * random.nextGaussian();
    }
}
