package rsal.navigation.explore;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

class VisitedCellsTest {
    private static final OccupancyGrid UNKNOWN = unknown();

    private static OccupancyGrid unknown() {
        var cells = new byte[20 * 10];
        Arrays.fill(cells, OccupancyGrid.UNKNOWN);
        cells[5 * 20 + 6] = OccupancyGrid.OCCUPIED; // at 0.65, 0.55
        return new OccupancyGrid(20, 10, 0.1, 0, 0, cells);
    }

    @Test
    void whereARobotStandsIsFreeButForWhatWasHit() {
        OccupancyGrid map = VisitedCells.free(UNKNOWN, List.of(new Point2d(0.5, 0.5)), 0.3);

        assertThat(map.isFree(0.5, 0.5)).isTrue();
        assertThat(map.isFree(0.25, 0.45)).isTrue();
        assertThat(map.at(6, 5)).isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(map.at(9, 5)).isEqualTo(OccupancyGrid.UNKNOWN);
        assertThat(UNKNOWN.isFree(0.5, 0.5)).as("the map it was given").isFalse();
    }

    @Test
    void atTheRimOfTheMapAndBeyondItHoldsToo() {
        OccupancyGrid map = VisitedCells.free(UNKNOWN, List.of(new Point2d(0.05, 0.05), new Point2d(9, -7)), 0.3);

        assertThat(map.isFree(0.05, 0.05)).isTrue();
        assertThat(map.at(19, 9)).isEqualTo(OccupancyGrid.UNKNOWN);
    }
}
