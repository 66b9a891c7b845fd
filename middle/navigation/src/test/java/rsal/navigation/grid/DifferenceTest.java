package rsal.navigation.grid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;

/// What is taken over from the map before is what would be measured anew.
class DifferenceTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void distancesAreThoseMeasuredAnew(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map = RandomMaps.of(random, 250 + random.nextInt(100), 250, random.nextDouble() * 0.01);
        var field = DistanceField.toNotFree(map);
        int takenOver = 0;
        for (int i = 0; i < 30; i++) {
            OccupancyGrid next = RandomMaps.changed(map, random);
            Optional<Difference> difference = Difference.between(map, next);
            var anew = DistanceField.toNotFree(next);
            if (difference.isPresent()) {
                takenOver += new DistanceRepair(difference.get(), meters(field))
                                .meters()
                                .isPresent()
                        ? 1
                        : 0;
                assertThat(Arrays.mismatch(meters(DistanceField.toNotFree(difference.get(), field)), meters(anew)))
                        .as("seed %d, %d", seed, i)
                        .isNegative();
            }
            map = next;
            field = anew;
        }
        assertThat(takenOver).as("taken over").isGreaterThan(5);
    }

    private static float[] meters(DistanceField field) {
        var meters = new float[field.width() * field.height()];
        for (int cell = 0; cell < meters.length; cell++) {
            meters[cell] = field.at(cell);
        }
        return meters;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void isInFewWindows(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map = RandomMaps.of(random, 400, 300, 0.01);
        byte[] cells = map.cells().clone();
        for (int i = 0; i < 6; i++) {
            int from = (50 * i + random.nextInt(40)) * 400 + 60 * i;
            Arrays.fill(cells, from, from + 7, (byte) (100 - cells[from]));
        }
        Difference difference = Difference.between(map, new OccupancyGrid(400, 300, 0.05, -1, 2, cells))
                .orElseThrow();
        assertThat(difference.windows()).hasSizeBetween(1, 6);
        for (int cell = 0; cell < cells.length; cell++) {
            int column = cell % 400;
            int row = cell / 400;
            if ((cells[cell] == OccupancyGrid.FREE) != (map.cells()[cell] == OccupancyGrid.FREE)) {
                assertThat(difference.windows()).anyMatch(window -> window.contains(column, row));
            }
        }
    }

    @Test
    void onlyWhatIsFreeOrNotCounts() {
        var random = new SplittableRandom(1);
        OccupancyGrid map = RandomMaps.of(random, 300, 300, 0.1);
        byte[] cells = map.cells().clone();
        for (int cell = 0; cell < cells.length; cell++) {
            cells[cell] = cells[cell] == OccupancyGrid.FREE ? OccupancyGrid.FREE : OccupancyGrid.UNKNOWN;
        }
        var other = new OccupancyGrid(300, 300, 0.05, -1, 2, cells);
        assertThat(Difference.between(map, other).orElseThrow().windows()).isEmpty();
    }

    @Test
    void isTooMuchWhereMostIsOtherwise() {
        var random = new SplittableRandom(1);
        OccupancyGrid map = RandomMaps.of(random, 300, 300, 0.1);
        assertThat(Difference.between(map, RandomMaps.of(random, 300, 300, 0.1)))
                .as("everywhere")
                .isEmpty();
        assertThat(Difference.between(map, new OccupancyGrid(300, 300, 0.05, -0.98, 2, map.cells())))
                .as("half a cell aside")
                .isEmpty();
        assertThat(Difference.between(map, new OccupancyGrid(300, 300, 0.05, 1e9, 2, map.cells())))
                .as("elsewhere")
                .isEmpty();
        var larger = new OccupancyGrid(300, 300, 0.1, -1, 2, map.cells());
        assertThat(MapOverlay.of(map, larger)).as("larger cells").isEmpty();
        assertThat(Difference.between(map, larger)).as("larger cells").isEmpty();
    }

    @Test
    void isTooMuchInTooManyPlaces() {
        int side = 2000;
        var map = new OccupancyGrid(side, side, 0.05, -1, 2, new byte[side * side]);
        byte[] cells = map.cells().clone();
        for (int place = 0; place < 64; place++) {
            cells[(100 + 200 * (place / 8)) * side + 100 + 200 * (place % 8)] = OccupancyGrid.OCCUPIED;
        }
        var changed = new OccupancyGrid(side, side, 0.05, -1, 2, cells.clone());
        assertThat(Difference.between(map, changed).orElseThrow().windows()).hasSize(64);
        cells[1900 * side + 1900] = OccupancyGrid.OCCUPIED;
        assertThat(Difference.between(map, new OccupancyGrid(side, side, 0.05, -1, 2, cells)))
                .isEmpty();
    }

    @Test
    void distancesOfAnotherMapAreNotTakenOver() {
        OccupancyGrid map = RandomMaps.of(new SplittableRandom(1), 300, 200, 0.01);
        Difference difference = Difference.between(map, map).orElseThrow();
        var turned = new OccupancyGrid(200, 300, 0.05, -1, 2, map.cells());
        var aside = new OccupancyGrid(300, 200, 0.05, -0.95, 2, map.cells());
        for (OccupancyGrid other : List.of(turned, aside)) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> DistanceField.toNotFree(difference, DistanceField.toNotFree(other)))
                    .withMessageContaining("is not of a map of 300 × 200 cells of 0.05 m from (-1.0, 2.0)");
        }
    }
}
