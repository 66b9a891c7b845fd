package rsal.navigation.wavefront;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap.Clearance;

class CostMapTest {
    /// A row of cells of 0.1 m between walls, of which the last but one knows nothing.
    private static OccupancyGrid corridor() {
        var cells = new byte[13 * 3];
        Arrays.fill(cells, OccupancyGrid.OCCUPIED);
        for (int column = 1; column < 12; column++) {
            cells[13 + column] = OccupancyGrid.FREE;
        }
        cells[13 + 10] = OccupancyGrid.UNKNOWN;
        return new OccupancyGrid(13, 3, 0.1, 0, 0, cells);
    }

    /// A map without walls but at its left.
    private static OccupancyGrid field() {
        var cells = new byte[20 * 9];
        for (int row = 0; row < 9; row++) {
            cells[20 * row] = OccupancyGrid.OCCUPIED;
        }
        return new OccupancyGrid(20, 9, 0.1, 0, 0, cells);
    }

    private static OccupancyGrid shown(OccupancyGrid grid, Clearance clearance) {
        return CostMap.of(grid, DistanceField.toNotFree(grid), clearance).shown();
    }

    @Test
    void showsWhereItIsDearAndWhereItCantBe() {
        OccupancyGrid shown = shown(field(), new Clearance(0.12, 0.62, 3));
        assertThat(shown.at(0, 4)).isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(shown.at(1, 4)).as("too near").isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(shown.at(2, 4)).as("as near as it may be").isEqualTo((byte) 99);
        for (int column = 3; column < 7; column++) {
            assertThat(shown.at(column, 4)).isBetween((byte) 1, (byte) (shown.at(column - 1, 4) - 1));
        }
        assertThat(shown.at(12, 4)).isEqualTo(OccupancyGrid.FREE);
        assertThat(shown.resolution()).isEqualTo(0.1);
    }

    @Test
    void showsWhatTheMapDoesNotKnow() {
        OccupancyGrid shown = shown(corridor(), new Clearance(0.04, 0.04, 0));
        assertThat(shown.at(5, 1)).as("nothing is dear").isEqualTo(OccupancyGrid.FREE);
        assertThat(shown.at(10, 1)).isEqualTo(OccupancyGrid.UNKNOWN);
        assertThat(shown.at(5, 0)).isEqualTo(OccupancyGrid.OCCUPIED);
    }
}
