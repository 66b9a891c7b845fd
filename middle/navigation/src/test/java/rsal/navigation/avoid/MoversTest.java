package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// A laser of 360 beams on a robot that moves, and discs around it.
class MoversTest {
    private static final double STEP = 0.1; // s
    private static final double RADIUS = 0.25; // m
    private static final int BEAMS = 720;

    private final Movers movers = new Movers();
    private final SplittableRandom random = new SplittableRandom(1);

    /// A person who walks across, while the robot drives along a curve.
    @Test
    void estimatesTheVelocityOfWhoWalksAcross() {
        Pose2d robot = Pose2d.ORIGIN;
        for (int i = 0; i < 12; i++) {
            robot = see(i, new Pose2d(0.04 * i, 0.002 * i * i, 0.06 * i), new Point2d(3, -2 + 1.4 * STEP * i));
        }
        assertThat(movers.count()).isEqualTo(1);
        double cos = Math.cos(robot.theta());
        double sin = Math.sin(robot.theta());
        assertThat(cos * movers.vx(0) - sin * movers.vy(0)).isCloseTo(0, within(0.15));
        assertThat(sin * movers.vx(0) + cos * movers.vy(0)).isCloseTo(1.4, within(0.15));
        Point2d place = robot.transform(new Point2d(movers.x(0), movers.y(0)));
        assertThat(place.x()).isCloseTo(3, within(0.15));
        assertThat(place.y()).isCloseTo(-2 + 1.4 * STEP * 11, within(0.15));
    }

    @Test
    void isFoundAfterHalfASecond() {
        for (int i = 0; i < 5; i++) {
            see(i, Pose2d.ORIGIN, new Point2d(4 - 1.4 * STEP * i, 0.5));
        }
        assertThat(movers.count()).isEqualTo(1);
        assertThat(movers.isComing(0)).isTrue();
        assertThat(movers.isAnyComing(4)).isTrue();
    }

    /// What stands does not move, though the robot passes it and sees other sides of it.
    @Test
    void whatStandsDoesNotMove() {
        for (int i = 0; i < 60; i++) {
            see(
                    i,
                    new Pose2d(0.04 * i, 0, 0.3 * Math.sin(0.4 * i)),
                    new Point2d(1.2, 0.8),
                    new Point2d(2, -1),
                    new Point2d(3.5, 0.2));
            assertThat(movers.count()).isZero();
        }
    }

    @Test
    void isForgottenSoonAfterItIsGone() {
        for (int i = 0; i < 10; i++) {
            see(i, Pose2d.ORIGIN, new Point2d(3, -1 + 1.4 * STEP * i));
        }
        assertThat(movers.count()).isEqualTo(1);
        for (int i = 10; i < 18; i++) {
            see(i, Pose2d.ORIGIN);
        }
        assertThat(movers.count()).isZero();
    }

    @Test
    void whatTheMapShowsIsNoMover() {
        for (int i = 0; i < 10; i++) {
            Point2d disc = new Point2d(3, -1 + 1.4 * STEP * i);
            movers.see(scan(Pose2d.ORIGIN, disc), time(i), Pose2d.ORIGIN, Pose2d.ORIGIN, (_, _, _) -> true);
        }
        assertThat(movers.count()).isZero();
    }

    private Pose2d see(int step, Pose2d odomFromBase, Point2d... discs) {
        movers.see(scan(odomFromBase, discs), time(step), odomFromBase, odomFromBase, (_, _, _) -> false);
        return odomFromBase;
    }

    private static Instant time(int step) {
        return Instant.EPOCH.plusMillis(100L * step);
    }

    /// With noise of 1 cm.
    private LaserScan scan(Pose2d odomFromBase, Point2d... discs) {
        var ranges = new float[BEAMS];
        Arrays.fill(ranges, Float.POSITIVE_INFINITY);
        double increment = 2 * Math.PI / BEAMS;
        Pose2d baseFromOdom = odomFromBase.inverse();
        for (Point2d disc : discs) {
            Point2d place = baseFromOdom.transform(disc);
            for (int beam = 0; beam < BEAMS; beam++) {
                double angle = -Math.PI + beam * increment;
                double along = place.x() * Math.cos(angle) + place.y() * Math.sin(angle);
                double beside = place.x() * Math.sin(angle) - place.y() * Math.cos(angle);
                if (along > 0 && Math.abs(beside) < RADIUS) {
                    double range = along - Math.sqrt(RADIUS * RADIUS - beside * beside) + 0.01 * random.nextGaussian();
                    ranges[beam] = Math.min(ranges[beam], (float) range);
                }
            }
        }
        return new LaserScan(Pose2d.ORIGIN, -Math.PI, increment, 0.02, 10, ranges);
    }
}
