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
