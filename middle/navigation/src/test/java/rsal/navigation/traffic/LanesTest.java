package rsal.navigation.traffic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;

/// In a corridor of 12 m along the x axis.
class LanesTest {
    private static final double RADIUS = 0.32; // m

    private static Lanes lanes(int width) {
        int length = 122;
        var cells = new byte[length * (width + 2)];
        Arrays.fill(cells, OccupancyGrid.OCCUPIED);
        for (int row = 1; row <= width; row++) {
            Arrays.fill(cells, row * length + 1, row * length + length - 1, OccupancyGrid.FREE);
        }
        return new Lanes(DistanceField.toNotFree(new OccupancyGrid(length, width + 2, 0.1, 0, 0, cells)), RADIUS);
    }

    @ParameterizedTest
    @ValueSource(ints = {17, 20, 24, 30})
    void whoComeTheOtherWayHaveAnotherLane(int width) {
        double middle = 0.1 * (width + 2) / 2;
        List<Point2d> there = lanes(width).right(List.of(new Point2d(1, middle), new Point2d(11, middle)));
        List<Point2d> back = lanes(width).right(List.of(new Point2d(11, middle), new Point2d(1, middle)));

        assertThat(there).filteredOn(LanesTest::isInside).isNotEmpty().allSatisfy(place -> {
            assertThat(place.y()).as("driving along x, right is below").isLessThan(middle - RADIUS);
            assertThat(place.y()).isGreaterThan(0.1 + RADIUS);
        });
        assertThat(back)
                .filteredOn(LanesTest::isInside)
                .isNotEmpty()
                .allSatisfy(place -> assertThat(place.y()).isGreaterThan(middle + RADIUS));
        assertThat(there.getFirst()).isEqualTo(new Point2d(1, middle));
        assertThat(there.getLast()).isEqualTo(new Point2d(11, middle));
    }

    /// A path that is in its lane, or in the wrong one, comes to the same lane.
    @ParameterizedTest
    @ValueSource(doubles = {0.6, 0.8, 1.1, 1.4, 1.6})
    void wherePathsWereBeforeDoesNotMatter(double y) {
        List<Point2d> lane = lanes(20).right(List.of(new Point2d(1, y), new Point2d(11, y)));

        assertThat(lane)
                .filteredOn(LanesTest::isInside)
                .allSatisfy(place -> assertThat(place.y()).isBetween(0.5, 0.7));
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 12, 15, 40})
    void narrowAndWideFloorsHaveNone(int width) {
        List<Point2d> path = List.of(new Point2d(1, 0.6), new Point2d(11, 0.6));

        assertThat(lanes(width).right(path)).isEqualTo(path);
    }

    private static boolean isInside(Point2d place) {
        return place.x() > 3 && place.x() < 9;
    }
}
