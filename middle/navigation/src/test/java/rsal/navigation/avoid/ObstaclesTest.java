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
    void sonarsAreAskedWhereBeamsAreBroken() {
        var broken = new LaserScan(Pose2d.ORIGIN, -0.1, 0.1, 0.02, 5, new float[] {1, Float.NaN, 1});
        obstacles.addBeside(broken, sonarAhead(0.02, 0.5f));
        assertThat(obstacles.count()).isPositive();
        obstacles.clear();
        var whole = new LaserScan(Pose2d.ORIGIN, -0.1, 0.1, 0.02, 5, new float[] {1, 1, 1});
        obstacles.addBeside(whole, sonarAhead(0.02, 0.5f));
        assertThat(obstacles.count()).isZero();
    }

    private static LaserScan ahead(double least, float range) {
        return new LaserScan(Pose2d.ORIGIN, 0, 0.1, least, 5, new float[] {range});
    }

    private static RangeArray sonarAhead(double least, float range) {
        return new RangeArray(List.of(Pose2d.ORIGIN), 0.3, least, 5, new float[] {range});
    }
}
