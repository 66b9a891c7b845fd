package rsal.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.settings.Location;

class RosMapTest {
    @Test
    void whatWasWrittenIsReadAgain() {
        byte[] cells = {OccupancyGrid.FREE, OccupancyGrid.OCCUPIED, OccupancyGrid.UNKNOWN, 0, 0, 100};
        var map = new OccupancyGrid(3, 2, 0.05, -1.25, 7, cells);
        Map<String, byte[]> files = Map.of(
                "lab.yaml", RosMap.yaml(map, "it's.pgm").getBytes(StandardCharsets.UTF_8), "it's.pgm", RosMap.pgm(map));

        OccupancyGrid read = new Maps((path, _, _) -> files.get(path)).read("lab.yaml", Location.of("test"));

        assertThat(read.cells()).containsExactly(cells);
        assertThat(read.width()).isEqualTo(3);
        assertThat(read.resolution()).isEqualTo(0.05);
        assertThat(read.originX()).isEqualTo(-1.25);
        assertThat(read.originY()).isEqualTo(7);
    }
}
