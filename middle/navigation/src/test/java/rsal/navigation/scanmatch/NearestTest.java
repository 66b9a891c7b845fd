package rsal.navigation.scanmatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
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
