package rsal.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.settings.Location;

class KnownMapsTest {
    private final Map<String, byte[]> files = new HashMap<>();
    private final KnownMaps known = new KnownMaps();

    @Test
    void aMapThatIsReadAgainHasTheSameCells() {
        draw("lab", "0 255 0 255");
        byte[] cells = read("lab").cells();
        assertThat(read("lab").cells()).isSameAs(cells);
        assertThat(read("lab")).isEqualTo(read("lab"));
    }

    @Test
    void anImageThatIsWrittenToIsReadAgain() {
        draw("lab", "0 255 0 255");
        assertThat(read("lab").cells()).containsExactly(100, 0, 100, 0);
        draw("lab", "255 255 0 255");
        assertThat(read("lab").cells()).containsExactly(100, 0, 0, 0);
    }

    @Test
    void anImageThatIsReadOtherwiseIsAnotherMap() {
        draw("lab", "0 255 0 255");
        byte[] cells = read("lab").cells();
        files.put("lab.yaml", yaml("lab", "negate: 1"));
        assertThat(read("lab").cells()).containsExactly(0, 100, 0, 100).isNotSameAs(cells);
    }

    @Test
    void onlyTheNewestFewAreKept() {
        draw("lab", "0 255 0 255");
        byte[] cells = read("lab").cells();
        for (int shade = 0; shade < 4; shade++) {
            draw("other", "0 255 0 " + shade);
            read("other");
        }
        assertThat(read("lab").cells()).isEqualTo(cells).isNotSameAs(cells);
    }

    private void draw(String name, String pixels) {
        files.put(name + ".pgm", ("P2 2 2 255 " + pixels + "\n").getBytes(StandardCharsets.US_ASCII));
        files.put(name + ".yaml", yaml(name, "negate: 0"));
    }

    private static byte[] yaml(String name, String negate) {
        return "image: %s.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n%s\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
                .formatted(name, negate)
                .getBytes(StandardCharsets.UTF_8);
    }

    private OccupancyGrid read(String name) {
        return new Maps((path, _, _) -> files.get(path), known).read(name + ".yaml", Location.of("test"));
    }
}
