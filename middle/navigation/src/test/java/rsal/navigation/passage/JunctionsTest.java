package rsal.navigation.passage;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

class JunctionsTest {
    /// Corridors of 4.5 m that begin at a place in the middle of a map.
    ///
    /// @param cells width of the corridors in cells of 0.1 m
    static OccupancyGrid star(int cells, boolean left, boolean right, boolean up, boolean down) {
        int arm = 45;
        int side = 2 * arm + cells + 2;
        var map = new byte[side * side];
        java.util.Arrays.fill(map, OccupancyGrid.OCCUPIED);
        for (int row = 1; row < side - 1; row++) {
            for (int column = 1; column < side - 1; column++) {
                boolean inRow = row > arm && row <= arm + cells;
                boolean inColumn = column > arm && column <= arm + cells;
                boolean free = (inRow && inColumn)
                        || (inRow && (column <= arm ? left : right))
                        || (inColumn && (row <= arm ? down : up));
                if (free) {
                    map[row * side + column] = OccupancyGrid.FREE;
                }
            }
        }
        return new OccupancyGrid(side, side, 0.1, 0, 0, map);
    }

    private static List<Junction> junctions(OccupancyGrid map) {
        return DrawnMaps.passages(map).junctions();
    }

    @ParameterizedTest
    @CsvSource({"18", "20", "24", "28"})
    void aCrossingOfWideCorridorsIsOneJunctionInItsMiddle(int cells) {
        OccupancyGrid map = star(cells, true, true, true, true);

        assertThat(junctions(map)).hasSize(1);
        double middle = map.width() * map.resolution() / 2;
        Junction junction = junctions(map).getFirst();
        assertThat(junction.mapFromCenter().distanceTo(new Point2d(middle, middle)))
                .isLessThan(0.2);
        assertThat(junction.radius()).as("its corners are in it").isGreaterThan(cells * 0.1 / Math.sqrt(2) - 0.1);
    }

    @ParameterizedTest
    @CsvSource({"18", "20", "24", "28"})
    void whereOneCorridorEndsAtAnotherIsAJunction(int cells) {
        assertThat(junctions(star(cells, true, true, false, true))).hasSize(1);
        assertThat(junctions(star(cells, false, true, true, true))).hasSize(1);
    }

    @ParameterizedTest
    @CsvSource({"18", "20", "24", "28"})
    void bendsAndStraightCorridorsAreNone(int cells) {
        assertThat(junctions(star(cells, true, true, false, false))).isEmpty();
        assertThat(junctions(star(cells, false, true, true, false))).isEmpty();
    }

    @Test
    void narrowCorridorsMeetInAPassage() {
        assertThat(junctions(star(12, true, true, true, true))).isEmpty();
    }

    @Test
    void roomsWithADoorAreNone() {
        assertThat(junctions(DrawnMaps.DOOR)).isEmpty();
    }

    @Test
    void aPathIsInAJunctionWhereItsPointsAre() {
        var junction = new Junction(new Point2d(5, 5), 1);

        List<Junction.Stretch> found =
                Junction.stretches(List.of(junction), List.of(new Point2d(1, 5), new Point2d(9, 5)), 8);

        assertThat(found).hasSize(1);
        assertThat(found.getFirst().from()).isBetween(3.0, 3.1);
        assertThat(found.getFirst().to()).isBetween(5.0, 5.1);
        assertThat(Junction.stretches(List.of(junction), List.of(new Point2d(1, 5), new Point2d(9, 5)), 2))
                .isEmpty();
    }
}
