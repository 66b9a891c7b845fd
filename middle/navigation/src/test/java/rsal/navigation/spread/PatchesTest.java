package rsal.navigation.spread;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.RandomMaps;

class PatchesTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void ofSingleCellsAreAsFarApartAsTheWaysBetween(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map = RandomMaps.of(random, 15, 12, 0.3 * random.nextDouble());
        var slow = new SlowPaths(map, 0);
        var ground = ReachableSpace.around(map, 0, slow.place(0));
        var patches = new Patches(ground, 1);
        int source = random.nextInt(slow.count());
        var flood = new Flood(patches);
        flood.source(patches.of(map.cell(slow.place(source))), 7);
        flood.flood();
        var sums = new double[8];
        flood.squares(sums);
        double unit = map.resolution() / Patches.FINENESS;

        assertThat(patches.count()).isEqualTo(slow.count());
        assertThat(Math.sqrt(sums[7] / slow.count()) * unit)
                .as("seed %d", seed)
                .isCloseTo(slow.measure(source).rms(), within(1e-3));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void areConnectedAndHoldEveryCell(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map = RandomMaps.of(random, 60, 50, 0.4 * random.nextDouble());
        var ground = ReachableSpace.largest(map, 0);
        var patches = new Patches(ground, random.nextInt(2, 12));
        var flood = new Flood(patches);
        flood.source(0, 0);
        flood.flood();
        int cells = 0;
        for (int patch = 0; patch < patches.count(); patch++) {
            cells += patches.weight(patch);
            assertThat(patches.of(patches.place(patch))).as("seed %d", seed).isEqualTo(patch);
            assertThat(flood.owner(patch)).as("seed %d", seed).isZero();
        }
        assertThat(cells).as("seed %d", seed).isEqualTo(ground.cells().length);
    }

    /// As many passes as are needed for blocks an eighth wider each: of a comb of corridors of one cell,
    /// which has a patch for each corridor in each block.
    @Test
    void areFewEnoughOnAMazeAfterFewSteps() {
        int width = 800;
        var cells = new byte[width * 300];
        for (int cell = 0; cell < cells.length; cell++) {
            boolean wall = cell % width % 2 == 0 && cell / width > 1;
            cells[cell] = wall ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        var ground = ReachableSpace.largest(new OccupancyGrid(width, 300, 0.05, 0, 0, cells), 0);
        var first = new Patches(ground, 3);

        Patches patches = Patches.atMost(ground, first, 3, 500);

        assertThat(first.count()).isGreaterThan(500);
        assertThat(patches.count()).isLessThanOrEqualTo(500);
        assertThat(patches.side() % 3).isZero();
        int narrower = patches.side() / 3 * 8 / 9 - 1;
        assertThat(new Patches(ground, 3 * narrower).count()).isGreaterThan(500);
        assertThat(Patches.atMost(ground, patches, 3, 500)).isSameAs(patches);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void belongToTheNearestSourceWheneverItWasAdded(long seed) {
        var random = new SplittableRandom(seed);
        var ground = ReachableSpace.largest(RandomMaps.of(random, 40, 30, 0.2), 0);
        var patches = new Patches(ground, 1);
        var atOnce = new Flood(patches);
        var oneByOne = new Flood(patches);
        for (int i = 0; i < 5; i++) {
            int source = random.nextInt(patches.count());
            atOnce.source(source, i);
            oneByOne.source(source, i);
            oneByOne.flood();
        }
        atOnce.flood();
        for (int patch = 0; patch < patches.count(); patch++) {
            assertThat(oneByOne.distance(patch)).as("seed %d", seed).isEqualTo(atOnce.distance(patch));
        }
    }
}
