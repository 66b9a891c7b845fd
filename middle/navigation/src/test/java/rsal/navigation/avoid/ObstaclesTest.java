package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;

class ObstaclesTest {
    private final Obstacles obstacles = new Obstacles(3);

    @Test
    void whatIsTooCloseIsAtTheLeastRange() {
        obstacles.add(ahead(0.2, 0.1f));
        assertThat(obstacles.count()).isEqualTo(1);
        assertThat(obstacles.x(0)).isCloseTo(0.2, within(1e-6));
    }

    @Test
    void noughtIsTooCloseOnlyWhereTheLeastRangeIsMore() {
        obstacles.add(ahead(0.2, 0));
        assertThat(obstacles.count()).isEqualTo(1);
        obstacles.clear();
        obstacles.add(ahead(0, 0));
        obstacles.add(sonarAhead(0, 0));
        assertThat(obstacles.count()).isZero();
        assertThat(obstacles.sight(0)).isZero();
    }

    @Test
    void sonarsAreAskedWhereAllBeamsAreBroken() {
        float no = Float.NaN;
        assertThat(heardBeside(1, no, no, no, 1)).isPositive();
        assertThat(heardBeside(1, 1, no, 1, 1)).isZero();
        assertThat(heardBeside(1, no, 1, no, 1)).isZero();
        assertThat(heardBeside(1, 1, 1, 1, 1)).isZero();
    }

    /// A beam's point is where it ends, as seen from the base: the mount, then the angle, then the range.
    @Test
    void pointsOfAScanAreWhereItsBeamsEnd() {
        var mount = new Pose2d(0.2, -0.1, 1.2);
        float[] ranges = {1, 0.5f, Float.POSITIVE_INFINITY, 1.5f, 3.2f};
        obstacles.add(new LaserScan(mount, -0.6, 0.3, 0.02, 5, ranges));
        assertThat(obstacles.count()).as("but what is too far away").isEqualTo(3);
        int at = 0;
        for (int beam : new int[] {0, 1, 3}) {
            double direction = 1.2 - 0.6 + 0.3 * beam;
            assertThat(obstacles.x(at)).isCloseTo(0.2 + ranges[beam] * Math.cos(direction), within(1e-6));
            assertThat(obstacles.y(at)).isCloseTo(-0.1 + ranges[beam] * Math.sin(direction), within(1e-6));
            assertThat(obstacles.at(at).x()).isEqualTo(obstacles.x(at));
            assertThat(obstacles.room(at)).isZero();
            at++;
        }
    }

    /// Within its reach from the base, not from the scanner.
    @Test
    void whatIsFartherAwayThanItsReachIsLeftOut() {
        var ahead = new Pose2d(0.5, 0, 0);
        obstacles.add(new LaserScan(ahead, 0, 0.1, 0.02, 9, new float[] {2.4f}));
        assertThat(obstacles.count()).isEqualTo(1);
        obstacles.clear();
        obstacles.add(new LaserScan(ahead, 0, 0.1, 0.02, 9, new float[] {2.6f}));
        assertThat(obstacles.count()).isZero();
        var back = new Pose2d(-0.5, 0, 0);
        obstacles.add(new LaserScan(back, 0, 0.1, 0.02, 9, new float[] {3.4f}));
        assertThat(obstacles.count())
                .as("beyond the reach as seen from a scanner behind")
                .isEqualTo(1);
    }

    /// At a third of its cone to each side, and straight ahead.
    @Test
    void aSonarsHitIsThreePointsAcrossItsCone() {
        var mount = new Pose2d(0.1, 0.2, -0.7);
        obstacles.add(new RangeArray(List.of(mount), 0.6, 0.1, 5, new float[] {1.5f}));
        assertThat(obstacles.count()).isEqualTo(3);
        for (int i = 0; i < 3; i++) {
            double direction = -0.7 + 0.2 * (i - 1);
            assertThat(obstacles.x(i)).isCloseTo(0.1 + 1.5 * Math.cos(direction), within(1e-6));
            assertThat(obstacles.y(i)).isCloseTo(0.2 + 1.5 * Math.sin(direction), within(1e-6));
        }
        obstacles.clear();
        obstacles.add(new RangeArray(List.of(mount), 0.6, 0.1, 5, new float[] {Float.POSITIVE_INFINITY}));
        assertThat(obstacles.count()).isZero();
    }

    @Test
    void keepsAnyNumberOfPoints() {
        for (int i = 0; i < 5000; i++) {
            double angle = 0.5 * i;
            obstacles.add((1 + i * 3e-4) * Math.cos(angle), (1 + i * 3e-4) * Math.sin(angle));
        }
        assertThat(obstacles.count()).isEqualTo(5000);
        obstacles.keepRoom(4999, 0.3);
        assertThat(obstacles.room(4999)).isCloseTo(0.3, within(1e-6));
        assertThat(obstacles.x(0)).isCloseTo(1, within(1e-6));
        assertThat(obstacles.y(4999)).isCloseTo((1 + 4999 * 3e-4) * Math.sin(2499.5), within(1e-5));
    }

    /// Of points one after the other those that are as good as the same count once.
    @Test
    void pointsThatAreTheSameCountOnce() {
        obstacles.add(1, 0);
        obstacles.add(1, 1e-4);
        assertThat(obstacles.count()).isEqualTo(1);
        obstacles.add(1, 0.2);
        obstacles.add(1.2, 0.2);
        assertThat(obstacles.count()).isEqualTo(3);
    }

    /// Nothing is nearer than where the beams end, as seen from the base; the nearest of those in a direction counts.
    @Test
    void seesAsFarAsTheShortestBeamInEachDirection() {
        float[] ranges = new float[360];
        for (int i = 0; i < 360; i++) {
            ranges[i] = i < 90 ? Float.NaN : i < 180 ? 1 : i < 270 ? 2 : Float.POSITIVE_INFINITY;
        }
        obstacles.add(new LaserScan(Pose2d.ORIGIN, Math.toRadians(0), Math.toRadians(1), 0.02, 5, ranges));
        int degree = Obstacles.SIGHTS / 360;
        assertThat(obstacles.sight(45 * degree)).isZero();
        assertThat(obstacles.sight(135 * degree)).isCloseTo(1, within(1e-6));
        assertThat(obstacles.sight(225 * degree)).isCloseTo(2, within(1e-6));
        assertThat(obstacles.sight(315 * degree)).as("as far as counts").isCloseTo(3, within(1e-6));
        var nearer = new LaserScan(Pose2d.ORIGIN, Math.toRadians(225), Math.toRadians(1), 0.02, 5, new float[] {1.5f});
        obstacles.add(nearer);
        assertThat(obstacles.sight(225 * degree)).isCloseTo(1.5, within(1e-6));
        obstacles.clear();
        assertThat(obstacles.sight(225 * degree)).isZero();
        var mounted = new Pose2d(0.5, 0, Math.PI / 2);
        obstacles.add(new LaserScan(mounted, 0, 0.1, 0.02, 5, new float[] {0.5f})); // ends at (0.5, 0.5)
        assertThat(obstacles.sight(45 * degree)).isCloseTo(Math.sqrt(0.5), within(1e-6));
    }

    /// How many points a sonar of 0.3 rad adds beside five beams, 0.1 rad apart.
    private int heardBeside(float... ranges) {
        obstacles.clear();
        obstacles.addBeside(new LaserScan(Pose2d.ORIGIN, -0.2, 0.1, 0.02, 5, ranges), sonarAhead(0.02, 0.5f));
        return obstacles.count();
    }

    @Test
    void aScanLooksWhereItsNearestBeamSaysSomething() {
        var ranges = new float[360];
        ranges[90] = Float.NaN;
        var around = new LaserScan(new Pose2d(0.1, 0, Math.PI), -Math.PI, Math.toRadians(1), 0.02, 5, ranges);
        for (int degree = 0; degree < 359; degree++) { // between the last beam and the first none looks
            assertThat(Obstacles.looks(around, Math.toRadians(degree + 0.4)))
                    .as("%d°", degree)
                    .isEqualTo(degree != 90);
        }
        assertThat(Obstacles.looks(ahead(0, -0.0f), 0)).isFalse();
        assertThat(Obstacles.looks(ahead(0, 1), 0)).isTrue();
        assertThat(Obstacles.looks(ahead(0, 1), 0.1)).isFalse();
        assertThat(Obstacles.looks(new LaserScan(Pose2d.ORIGIN, 0, 0, 0, 5, new float[0]), 0))
                .isFalse();
    }

    private static LaserScan ahead(double least, float range) {
        return new LaserScan(Pose2d.ORIGIN, 0, 0.1, least, 5, new float[] {range});
    }

    private static RangeArray sonarAhead(double least, float range) {
        return new RangeArray(List.of(Pose2d.ORIGIN), 0.3, least, 5, new float[] {range});
    }
}
