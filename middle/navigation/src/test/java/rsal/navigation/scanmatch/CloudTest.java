package rsal.navigation.scanmatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

class CloudTest {
    @Test
    void surfacesFaceAcrossTheirWalls() {
        var wall = new Walls().chain(2, -10, 2, 10);
        Cloud cloud = Cloud.of(wall.scan(Pose2d.ORIGIN, 0, new SplittableRandom(1)), 5);

        int ahead = cloud.count() / 2;
        assertThat(cloud.x(ahead)).isBetween(1.99, 2.01);
        assertThat(Math.abs(cloud.normalX[ahead])).isGreaterThan(0.999);
        assertThat(Math.abs(cloud.movedBy(new Pose2d(1, 1, Math.PI / 2)).normalY[ahead]))
                .isGreaterThan(0.999);
    }

    @Test
    void takesOnlyWhatWasHitNearEnough() {
        float[] ranges = {1, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, 0.01f, 9, 2};
        var scan = new LaserScan(new Pose2d(0.5, 0, 0), 0, 0.1, 0.05, 20, ranges);

        Cloud cloud = Cloud.of(scan, 5);

        assertThat(cloud.count()).isEqualTo(2);
        assertThat(cloud.x(0)).isEqualTo(1.5);
    }

    @Test
    void thinsToOnePointInACell() {
        Cloud cloud = Cloud.of(Walls.room().scan(new Pose2d(3, 3, 0), 0, new SplittableRandom(1)), 25);

        Cloud thin = cloud.thinned(0.5);

        assertThat(thin.count()).isBetween(10, cloud.count() / 2);
        assertThat(thin.thinned(0.5).count()).isEqualTo(thin.count());
    }
}
