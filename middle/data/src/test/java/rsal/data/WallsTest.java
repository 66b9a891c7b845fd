package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class WallsTest {
    /// Whether any cell that is occupied is crossed, each looked at by itself.
    private static boolean anyCrossed(OccupancyGrid map, Point2d one, Point2d other) {
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                if (map.at(column, row) == OccupancyGrid.OCCUPIED && crosses(map, column, row, one, other)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Clips the line to the cell: what is left of it has a length.
    private static boolean crosses(OccupancyGrid map, int column, int row, Point2d one, Point2d other) {
        double half = map.resolution() / 2;
        double[] x = clipped(one.x(), other.x(), map.x(column) - half, map.x(column) + half);
        double[] y = clipped(one.y(), other.y(), map.y(row) - half, map.y(row) + half);
        return Math.max(0, Math.max(x[0], y[0])) < Math.min(1, Math.min(x[1], y[1]));
    }

    /// From which part of the way to which a coordinate is between two bounds.
    private static double[] clipped(double from, double to, double least, double most) {
        double one = (least - from) / (to - from);
        double other = (most - from) / (to - from);
        return new double[] {Math.min(one, other), Math.max(one, other)};
    }

    @Test
    void lookingAtEachCellFindsTheSame() {
        var random = new SplittableRandom(3);
        int blocked = 0;
        for (int i = 0; i < 20_000; i++) {
            int width = random.nextInt(1, 12);
            int height = random.nextInt(1, 12);
            byte[] cells = new byte[width * height];
            for (int cell = 0; cell < cells.length; cell++) {
                cells[cell] = random.nextInt(8) == 0 ? OccupancyGrid.OCCUPIED : random.nextBoolean() ? 0 : (byte) -1;
            }
            var map = new OccupancyGrid(width, height, random.nextDouble(0.01, 1), -2, 1, cells);
            Point2d one = somewhere(map, random);
            Point2d other = somewhere(map, random);
            boolean expected = anyCrossed(map, one, other);
            var walls = new Walls(map);
            assertThat(walls.standBetween(one, other))
                    .as("%s, %s to %s", i, one, other)
                    .isEqualTo(expected);
            assertThat(walls.standBetween(other, one)).isEqualTo(expected);
            blocked += expected ? 1 : 0;
        }
        assertThat(blocked).isBetween(4_000, 16_000);
    }

    /// On the map or a little outside.
    private static Point2d somewhere(OccupancyGrid map, SplittableRandom random) {
        return new Point2d(
                map.originX() + random.nextDouble(-0.3, 1.3) * map.width() * map.resolution(),
                map.originY() + random.nextDouble(-0.3, 1.3) * map.height() * map.resolution());
    }

    @Test
    void alongRowsAndColumnsToo() {
        var map = new OccupancyGrid(3, 3, 1, 0, 0, new byte[] {0, 0, 0, 0, 100, 0, 0, 0, 0});
        var walls = new Walls(map);
        assertThat(walls.standBetween(new Point2d(0.5, 1.5), new Point2d(2.5, 1.5)))
                .isTrue();
        assertThat(walls.standBetween(new Point2d(1.5, 2.5), new Point2d(1.5, 0.5)))
                .isTrue();
        assertThat(walls.standBetween(new Point2d(0.5, 0.5), new Point2d(2.5, 0.5)))
                .isFalse();
        assertThat(walls.standBetween(new Point2d(0.5, 2.5), new Point2d(0.5, 0.5)))
                .isFalse();
        assertThat(walls.standBetween(new Point2d(-1e9, 1.5), new Point2d(1e9, 1.6)))
                .isTrue();
        assertThat(walls.standBetween(new Point2d(0.5, 0.5), new Point2d(0.5, 0.5)))
                .isFalse();
    }

    /// A wall with a gap of a cell, at x from 3 to 4 m; who looks stands at its left.
    @Test
    void whoIsSeenInPartIsNotHidden() {
        var cells = new byte[7 * 5];
        for (int row = 0; row < 5; row++) {
            cells[row * 7 + 3] = row == 1 ? OccupancyGrid.FREE : OccupancyGrid.OCCUPIED;
        }
        var walls = new Walls(new OccupancyGrid(7, 5, 1, 0, 0, cells));
        double gap = walls.standBetween(new Point2d(1, 3.5), new Point2d(6, 3.5)) ? 1.5 : 3.5;
        var from = new Point2d(1, gap);
        assertThat(walls.hide(from, new Point2d(6, gap), 0.3)).isFalse();
        assertThat(walls.hide(from, new Point2d(6, gap + 1), 0.3))
                .as("its side is seen through the gap")
                .isFalse();
        assertThat(walls.hide(from, new Point2d(6, gap + 1), 0.01)).isTrue();
        assertThat(walls.hide(from, new Point2d(6, gap + 3), 0.3)).isTrue();
        assertThat(walls.hide(from, from, 0.3)).isFalse();
    }
}
