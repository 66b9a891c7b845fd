package rsal.server.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;

class PackedMapTest {
    @Test
    void isUnpackedAsItWas() {
        byte[] cells = new byte[70 * 130];
        new Random(3).nextBytes(cells);
        var map = new OccupancyGrid(70, 130, 0.05, -1.5, 2, cells);
        OccupancyGrid unpacked = PackedMap.of(map).map();
        assertThat(unpacked).usingRecursiveComparison().isEqualTo(map);
    }

    @Test
    void isSmall() {
        byte[] cells = new byte[400 * 400];
        Arrays.fill(cells, OccupancyGrid.UNKNOWN);
        Arrays.fill(cells, 20_000, 60_000, OccupancyGrid.FREE);
        PackedMap packed = PackedMap.of(new OccupancyGrid(400, 400, 0.05, 0, 0, cells));
        assertThat(packed.cells().length).isLessThan(cells.length / 50);
    }
}
