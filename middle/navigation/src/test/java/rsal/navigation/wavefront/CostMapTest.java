package rsal.navigation.wavefront;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.Difference;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.RandomMaps;
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

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void overAChangedMapIsWhatIsReckonedAnew(long seed) {
        var random = new SplittableRandom(seed);
        double comfort = seed % 4 == 0 ? 3 : 0.14 + random.nextInt(3) * 0.1;
        var clearance = new Clearance(random.nextInt(3) * 0.07, comfort, random.nextInt(6));
        OccupancyGrid grid = RandomMaps.of(random, 250 + random.nextInt(100), 250, random.nextDouble() * 0.02);
        CostMap map = CostMap.of(grid, DistanceField.toNotFree(grid), clearance);
        int takenOver = 0;
        for (int i = 0; i < 30; i++) {
            OccupancyGrid next = RandomMaps.changed(map.grid(), random);
            var toNotFree = DistanceField.toNotFree(next);
            CostMap anew = CostMap.of(next, toNotFree, clearance);
            Optional<Difference> difference = Difference.between(map.grid(), next);
            if (difference.isPresent()) {
                CostMap over = map.over(difference.get(), toNotFree);
                assertThat(Arrays.mismatch(over.ground(), anew.ground()))
                        .as("ground, seed %d, %d", seed, i)
                        .isNegative();
                assertThat(Arrays.mismatch(over.shore(), anew.shore()))
                        .as("shore, seed %d, %d", seed, i)
                        .isNegative();
                takenOver++;
                map = over;
            } else {
                map = anew;
            }
        }
        assertThat(takenOver).isGreaterThan(5);
    }

    @Test
    void whereRobotsHaveBeenIsNotTakenOver() {
        OccupancyGrid grid = RandomMaps.of(new SplittableRandom(1), 200, 200, 0.2);
        var toNotFree = DistanceField.toNotFree(grid);
        var clearance = new Clearance(0.2, 0.4, 3);
        var way = List.of(new Point2d(0, 5), new Point2d(3, 9));
        CostMap driven = CostMap.of(grid, toNotFree, clearance, List.of(way));
        CostMap anew = CostMap.of(grid, toNotFree, clearance);
        assertThat(driven.ground()).isNotEqualTo(anew.ground());
        Difference none = Difference.between(grid, grid).orElseThrow();
        assertThat(driven.over(none, toNotFree).ground()).isEqualTo(anew.ground());
    }

    @Test
    void isTakenOverOnlyByADifferenceFromItsOwnMap() {
        OccupancyGrid grid = RandomMaps.of(new SplittableRandom(1), 200, 100, 0.02);
        var toNotFree = DistanceField.toNotFree(grid);
        CostMap map = CostMap.of(grid, toNotFree, new Clearance(0.2, 0.4, 3));
        var turned = new OccupancyGrid(100, 200, 0.05, -1, 2, grid.cells());
        var aside = new OccupancyGrid(200, 100, 0.05, -0.95, 2, grid.cells());
        var alike = new OccupancyGrid(200, 100, 0.05, -1, 2, grid.cells().clone());
        for (OccupancyGrid other : List.of(turned, aside)) {
            Difference none = Difference.between(other, other).orElseThrow();
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> map.over(none, DistanceField.toNotFree(other)))
                    .withMessageContaining("Costs of a map of 200 × 100 cells of 0.05 m from (-1.0, 2.0)");
            assertThatIllegalArgumentException()
                    .isThrownBy(() ->
                            map.over(Difference.between(grid, grid).orElseThrow(), DistanceField.toNotFree(other)))
                    .withMessageContaining("is not of a map");
        }
        Difference none = Difference.between(alike, alike).orElseThrow();
        assertThat(map.over(none, toNotFree).ground()).isEqualTo(map.ground());
    }

    /// 1 + w ((comfort - d) / (comfort - radius))², between the radius and comfort.
    @Test
    void costsRiseWithTheSquareOfWhatIsMissingToComfort() {
        for (double weight : new double[] {0, 1, 5}) {
            var clearance = new CostMap.Clearance(0.2, 0.7, weight);
            double most = clearance.cost(0.7);
            for (double distance = 0.2; distance <= 1; distance += 0.05) {
                double missing = Math.max(0, (0.7 - distance) / 0.5);
                assertThat(clearance.cost(distance) / most)
                        .as("%s m, weight %s", distance, weight)
                        .isCloseTo(1 + weight * missing * missing, within(0.6 / most));
            }
        }
    }
}
