package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;

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
}
