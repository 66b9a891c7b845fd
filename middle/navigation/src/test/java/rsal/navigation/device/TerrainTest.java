package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.RandomMaps;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Wavefront;

class TerrainTest {
    private static final Clearance SMALL = new Clearance(0.06, 0.2, 3);
    private static final Clearance LARGE = new Clearance(0.14, 0.5, 5);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void isAsIfTheMapHadAlwaysBeenSo(long seed) {
        var random = new SplittableRandom(seed);
        Terrain terrain = Terrain.of(RandomMaps.of(random, 200, 150, 0.003), null);
        int handedOn = 0;
        for (int look = 0; look < 30; look++) {
            OccupancyGrid map = RandomMaps.changed(terrain.map(), random);
            terrain = Terrain.of(map, terrain);
            var toNotFree = DistanceField.toNotFree(map);
            String what = "seed %d, look %d".formatted(seed, look);
            assertThat(meters(terrain.toNotFree())).as(what).isEqualTo(meters(toNotFree));
            for (Clearance clearance : List.of(SMALL, LARGE)) {
                if (random.nextInt(4) > 0) {
                    Wavefront wavefront = terrain.wavefront(clearance);
                    handedOn += wavefront.kept();
                    var fresh = new Wavefront(CostMap.of(map, toNotFree, clearance));
                    assertThat(wavefront.map().grid()).as(what).isSameAs(map);
                    assertThat(wavefront.map().shown().cells())
                            .as(what)
                            .isEqualTo(fresh.map().shown().cells());
                    var start = new Point2d(random.nextDouble(0, 8), random.nextDouble(3, 9));
                    var goal = new Point2d(4, 6);
                    assertThat(wavefront.plan(start, goal, 1)).as(what).isEqualTo(fresh.plan(start, goal, 1));
                }
            }
        }
        assertThat(handedOn).as("waves").isPositive();
    }

    private static float[] meters(DistanceField field) {
        var meters = new float[field.width() * field.height()];
        for (int cell = 0; cell < meters.length; cell++) {
            meters[cell] = field.at(cell);
        }
        return meters;
    }

    @Test
    void whatNobodyAskedForOnTheLastMapIsForgotten() {
        OccupancyGrid map = RandomMaps.of(new SplittableRandom(1), 200, 150, 0.001);
        var first = Terrain.of(map, null);
        for (Clearance clearance : List.of(SMALL, LARGE)) {
            for (int i = 0; i < 2; i++) {
                first.wavefront(clearance).plan(new Point2d(1, 4), new Point2d(7, 8), 1);
            }
        }
        var second = Terrain.of(map, first);
        assertThat(second.wavefront(SMALL).kept())
                .as("asked for on the first map")
                .isEqualTo(1);
        var third = Terrain.of(map, second);
        assertThat(third.wavefront(SMALL).kept()).as("asked for on both").isEqualTo(1);
        assertThat(third.wavefront(LARGE).kept())
                .as("not asked for on the second")
                .isZero();
    }
}
