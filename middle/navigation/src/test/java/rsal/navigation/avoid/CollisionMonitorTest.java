package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;

class CollisionMonitorTest {
    private static final Footprint BOX = Footprint.box(0.6, 0.4, new Point2d(-0.1, 0));
    private static final DriveLimits LIMITS = new DriveLimits(1, 2, 0.5, 4);

    private final CollisionMonitor guard = new CollisionMonitor(BOX, LIMITS, 0.05, 0.2);
    private final Obstacles obstacles = new Obstacles(5);

    @Test
    void letsThroughWhatIsFree() {
        obstacles.add(2, 0);
        assertThat(guard.limit(Twist2d.drive(1, 0.3), Twist2d.STOP, obstacles)).isEqualTo(Twist2d.drive(1, 0.3));
    }

    @Test
    void stopsWhereNumbersSayNothing() {
        var unknown = new Twist2d(Double.NaN, 0, 0);
        obstacles.add(0.26, 0);
        assertThat(guard.limit(Twist2d.drive(1, 0), unknown, obstacles)).isEqualTo(Twist2d.STOP);
        assertThat(guard.limit(unknown, Twist2d.STOP, obstacles)).isEqualTo(Twist2d.STOP);
        assertThat(guard.limit(Twist2d.drive(0, Double.POSITIVE_INFINITY), Twist2d.STOP, new Obstacles(5)))
                .isEqualTo(Twist2d.STOP);
    }

    @Test
    void slowsDownInTimeToStop() {
        obstacles.add(0.75, 0); // 0.55 m before the bumper; from 1 m/s it takes 1 m to stop
        Twist2d limited = guard.limit(Twist2d.drive(1, 0), Twist2d.drive(0.6, 0), obstacles);
        assertThat(limited.vx()).isBetween(0.1, 0.8);
    }

    @Test
    void stopsBeforeWhatIsAhead() {
        obstacles.add(0.26, 0);
        assertThat(guard.limit(Twist2d.drive(0.5, 0), Twist2d.STOP, obstacles)).isEqualTo(Twist2d.STOP);
        assertThat(guard.limit(Twist2d.drive(-0.5, 0), Twist2d.STOP, obstacles)).isEqualTo(Twist2d.drive(-0.5, 0));
    }

    @Test
    void doesNotSwingItsTailIntoAPost() {
        obstacles.add(-0.35, -0.27); // right behind the rear wheel
        assertThat(guard.limit(Twist2d.drive(0, 1), Twist2d.STOP, obstacles).omega())
                .isLessThan(0.5);
        assertThat(guard.limit(Twist2d.drive(0, -1), Twist2d.STOP, obstacles)).isEqualTo(Twist2d.drive(0, -1));
    }

    @Test
    void leavesWhatItTouches() {
        obstacles.add(0.2, 0.1);
        assertThat(guard.limit(Twist2d.drive(0.2, 0), Twist2d.STOP, obstacles).vx())
                .isZero();
        assertThat(guard.limit(Twist2d.drive(-0.2, 0), Twist2d.STOP, obstacles).vx())
                .isEqualTo(-0.2);
    }

    @Test
    void keepsMoreRoomFromWhatMayMove() {
        obstacles.add(0.35, 0);
        assertThat(guard.limit(Twist2d.drive(0.1, 0), Twist2d.STOP, obstacles).vx())
                .isEqualTo(0.1);
        obstacles.keepRoom(0, 0.2);
        assertThat(guard.limit(Twist2d.drive(0.1, 0), Twist2d.STOP, obstacles).vx())
                .isZero();
    }

    @Test
    void keepsMoreRoomFromWhatItRemembersBehind() {
        obstacles.add(-0.47, 0); // 7 cm behind the rear
        assertThat(guard.limit(Twist2d.drive(-0.1, 0), Twist2d.STOP, obstacles).vx())
                .isZero();
        obstacles.clear();
        obstacles.add(0.27, 0); // 7 cm ahead
        assertThat(guard.limit(Twist2d.drive(0.05, 0), Twist2d.STOP, obstacles).vx())
                .isPositive();
    }

    @Test
    void doesNotGoBackwardPastWhatMayMove() {
        obstacles.add(0.1, 0.4); // beside it, clear of the way back
        assertThat(guard.limit(Twist2d.drive(-0.1, 0), Twist2d.STOP, obstacles).vx())
                .isEqualTo(-0.1);
        obstacles.keepRoom(0, 0.05);
        assertThat(guard.limit(Twist2d.drive(-0.1, 0), Twist2d.STOP, obstacles)).isEqualTo(Twist2d.STOP);
        obstacles.clear();
        obstacles.add(0.4, 0.1);
        obstacles.keepRoom(0, 0.05);
        assertThat(guard.limit(Twist2d.drive(-0.1, 0), Twist2d.STOP, obstacles).vx())
                .isEqualTo(-0.1);
    }

    /// How far it goes straight on until it stands: it takes up the command for the reaction time and brakes then.
    private static double stoppingDistance(double velocity, double command, double reaction) {
        double dt = 1e-4;
        double v = velocity;
        double distance = 0;
        for (double time = 0; time < reaction || v > 1e-6; time += dt) {
            double wanted = time < reaction ? command : 0;
            v += Math.clamp(wanted - v, -LIMITS.acceleration() * dt, LIMITS.acceleration() * dt);
            distance += v * dt;
        }
        return distance;
    }

    /// With what is ahead at any distance, and at any speed that it has: the fastest share from which it can stop.
    @Test
    void letsThroughTheFastestShareFromWhichItStops() {
        for (double reaction : new double[] {0.1, 0.4}) {
            var monitor = new CollisionMonitor(BOX, LIMITS, 0.05, reaction);
            for (double velocity : new double[] {0, 0.4, 0.8}) {
                for (double gap = 0.06; gap < 2.5; gap += 0.07) {
                    obstacles.clear();
                    obstacles.add(0.2 + gap, 0);
                    double room = gap - 0.05;
                    double got = monitor.limit(Twist2d.drive(1, 0), Twist2d.drive(velocity, 0), obstacles)
                            .vx();
                    double slack = 0.06; // steps of 0.04 m
                    double expectedLeast = 0;
                    double expectedMost = 0;
                    for (double share : new double[] {0.15, 0.3, 0.5, 0.75, 1}) {
                        double distance = stoppingDistance(velocity, share, reaction);
                        expectedLeast = distance < room - slack ? share : expectedLeast;
                        expectedMost = distance < room + slack ? share : expectedMost;
                    }
                    assertThat(got)
                            .as("reaction %s s, %s m/s, gap %s m", reaction, velocity, gap)
                            .isBetween(expectedLeast, expectedMost);
                }
            }
        }
    }

    /// It slows down on the same arc: speed and turn by the same share.
    @Test
    void slowsDownOnTheSameArc() {
        for (double omega : new double[] {0.6, -0.6}) {
            obstacles.clear();
            obstacles.add(0.55, Math.copySign(0.08, omega));
            Twist2d limited = guard.limit(Twist2d.drive(1, omega), Twist2d.drive(0.4, 0.4 * omega), obstacles);
            assertThat(limited.vx()).isBetween(0.14, 0.76);
            assertThat(limited.omega() / limited.vx()).isCloseTo(omega, within(1e-12));
        }
    }

    /// On an arc to the left it does not mind what is ahead to the right.
    @Test
    void looksAlongTheArcToTheRightSide() {
        for (double side : new double[] {1, -1}) {
            obstacles.clear();
            obstacles.add(0.5, -side * 0.2);
            Twist2d away = Twist2d.drive(0.5, side * 0.8);
            assertThat(guard.limit(away, away, obstacles)).isEqualTo(away);
            Twist2d there = Twist2d.drive(0.5, -side * 0.8);
            assertThat(guard.limit(there, there, obstacles).vx()).isLessThan(0.5);
        }
    }
}
