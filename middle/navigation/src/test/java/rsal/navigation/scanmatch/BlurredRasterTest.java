package rsal.navigation.scanmatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Pose2d;

class BlurredRasterTest {
    private static final int STEPS = 1 << 12; // of the table of brightness

    @ParameterizedTest
    @CsvSource({"0.05, 0.05", "0.05, 0.02", "0.03, 0.1", "0.2, 0.05"})
    void eachCellIsAsBrightAsTheNearestPointMakesIt(double resolution, double blur) {
        Cloud cloud = Cloud.of(Walls.room().scan(new Pose2d(3, 2, 0.5), 0.01, new SplittableRandom(2)), 25);
        var raster = new BlurredRaster(cloud, resolution, blur, 0);
        int bright = 0;
        for (int row = 0; row < raster.height; row++) {
            for (int column = 0; column < raster.width; column++) {
                int expected = slowly(cloud, raster, column, row, blur);
                assertThat(raster.sum(0, new int[] {column}, new int[] {row}, 1, 0, 0))
                        .as("%d, %d", column, row)
                        .isEqualTo(expected);
                bright += expected > 0 ? 1 : 0;
            }
        }
        assertThat(bright).isBetween(100, raster.width * raster.height - 100);
    }

    /// Looks at all points that may be drawn there.
    private static int slowly(Cloud cloud, BlurredRaster raster, int column, int row, double blur) {
        double step = 3.5 * blur * 3.5 * blur / STEPS;
        int reach = (int) Math.ceil(3 * blur / raster.resolution);
        int most = 0;
        for (int i = 0; i < cloud.count(); i++) {
            boolean near = Math.abs((int) ((cloud.x[i] - raster.originX) / raster.resolution) - column) <= reach
                    && Math.abs((int) ((cloud.y[i] - raster.originY) / raster.resolution) - row) <= reach;
            if (near) {
                double dx = raster.originX + (column + 0.5) * raster.resolution - cloud.x[i];
                double dy = raster.originY + (row + 0.5) * raster.resolution - cloud.y[i];
                int index = (int) ((dx * dx + dy * dy) / step);
                most = index < STEPS ? Math.max(most, (int) (255 * Math.exp(-index * step / (2 * blur * blur)))) : most;
            }
        }
        return most;
    }
}
