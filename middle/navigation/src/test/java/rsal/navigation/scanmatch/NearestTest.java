package rsal.navigation.scanmatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

class NearestTest {
    @Test
    void findsThePointThatLookingAtAllFinds() {
        Cloud cloud = seen();
        var nearest = new Nearest(cloud);
        var random = new SplittableRandom(1);
        int found = 0;
        for (int i = 0; i < 5000; i++) {
            double x = random.nextDouble(-8, 8);
            double y = random.nextDouble(-8, 8);
            double within = random.nextDouble(0, 1);
            int right = slowly(cloud, x, y, within);
            assertThat(nearest.find(x, y, within))
                    .as("%s, %s within %s", x, y, within)
                    .isEqualTo(right);
            found += right >= 0 ? 1 : 0;
        }
        assertThat(found).isBetween(300, 4700);
    }

    /// Of clouds with a few points far from each other, where most rings are empty, and near their points.
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 10, 40, 200})
    void findsWhatLookingAtAllFindsWhereverPointsAre(int every) {
        LaserScan scan = Walls.room().scan(new Pose2d(3, 2, 0.5), 0.01, new SplittableRandom(2));
        float[] ranges = scan.ranges().clone();
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = i % every == 0 ? ranges[i] : Float.NaN;
        }
        var thinned = new LaserScan(
                scan.baseFromLaser(), scan.angleMin(), scan.angleIncrement(), scan.rangeMin(), scan.rangeMax(), ranges);
        Cloud cloud = Cloud.of(thinned, 25);
        var nearest = new Nearest(cloud);
        var random = new SplittableRandom(every);
        for (int i = 0; i < 3000; i++) {
            int point = random.nextInt(cloud.count());
            double off = random.nextInt(3) * 0.15;
            double x = cloud.x[point] + off * random.nextGaussian();
            double y = cloud.y[point] + off * random.nextGaussian();
            double within = random.nextDouble(0, 3);
            assertThat(nearest.find(x, y, within))
                    .as("%s, %s within %s", x, y, within)
                    .isEqualTo(slowly(cloud, x, y, within));
        }
    }

    @Test
    void findsNothingFarAwayNorAtNoPlace() {
        var nearest = new Nearest(seen());
        assertThat(nearest.find(1e9, -1e9, 0.4)).isEqualTo(-1);
        assertThat(nearest.find(Double.NaN, 0, 0.4)).isEqualTo(-1);
    }

    private static Cloud seen() {
        return Cloud.of(Walls.room().scan(new Pose2d(3, 2, 0.5), 0.01, new SplittableRandom(2)), 25);
    }

    private static int slowly(Cloud cloud, double x, double y, double within) {
        int nearest = -1;
        double least = within * within;
        for (int i = 0; i < cloud.count(); i++) {
            double dx = cloud.x[i] - x;
            double dy = cloud.y[i] - y;
            if (dx * dx + dy * dy < least) {
                least = dx * dx + dy * dy;
                nearest = i;
            }
        }
        return nearest;
    }
}
