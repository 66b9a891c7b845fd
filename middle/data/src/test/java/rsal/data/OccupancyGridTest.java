package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class OccupancyGridTest {
    private static final OccupancyGrid GRID = new OccupancyGrid(3, 2, 0.5, -1, -2, new byte[] {
        OccupancyGrid.FREE, OccupancyGrid.OCCUPIED, OccupancyGrid.UNKNOWN, //
        OccupancyGrid.OCCUPIED, OccupancyGrid.FREE, OccupancyGrid.FREE
    });

    @Test
    void everyCellsMiddleLiesInIt() {
        for (int row = 0; row < 2; row++) {
            for (int column = 0; column < 3; column++) {
                assertThat(GRID.column(GRID.x(column))).isEqualTo(column);
                assertThat(GRID.row(GRID.y(row))).isEqualTo(row);
            }
        }
        assertThat(GRID.x(0)).isEqualTo(-0.75);
        assertThat(GRID.y(1)).isEqualTo(-1.25);
    }

    @Test
    void whatIsOutsideIsUnknownAndNotFree() {
        assertThat(GRID.at(-1, 0)).isEqualTo(OccupancyGrid.UNKNOWN);
        assertThat(GRID.at(3, 0)).isEqualTo(OccupancyGrid.UNKNOWN);
        assertThat(GRID.isFree(-1.01, -1.75)).isFalse();
        assertThat(GRID.isFree(Double.POSITIVE_INFINITY, 0)).isFalse();
        assertThat(GRID.isFree(Double.NaN, -1.75)).isFalse();
        assertThat(GRID.isFree(-0.75, Double.NaN)).isFalse();
        assertThat(GRID.isFree(-0.75, -1.75)).isTrue();
        assertThat(GRID.isFree(-0.25, -1.75)).isFalse();
    }

    @Test
    void ofSeveralCellsAnOccupiedOneCountsMostAndThenAFreeOne() {
        assertThat(GRID.darkest(0, 0, 3, 2)).isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(GRID.darkest(2, 0, 3, 2)).isEqualTo(OccupancyGrid.FREE);
        assertThat(GRID.darkest(2, 0, 5, 1)).isEqualTo(OccupancyGrid.UNKNOWN);
        assertThat(GRID.darkest(1, 0, 2, 1)).isEqualTo(OccupancyGrid.OCCUPIED);
        assertThat(GRID.darkest(1, 1, 2, 2)).isEqualTo(OccupancyGrid.FREE);
        assertThat(GRID.darkest(1, 1, 1, 2)).isEqualTo(OccupancyGrid.UNKNOWN);
    }

    @Test
    void refusesWhatDoesNotFitTogether() {
        assertThatIllegalArgumentException().isThrownBy(() -> grid(2, 2, 1, 3));
        assertThatIllegalArgumentException().isThrownBy(() -> grid(0, 2, 1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> grid(1 << 16, 1 << 16, 1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> grid(1, 1, 0, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> grid(1, 1, Double.NaN, 1));
    }

    private static OccupancyGrid grid(int width, int height, double resolution, int cells) {
        return new OccupancyGrid(width, height, resolution, 0, 0, new byte[cells]);
    }
}
