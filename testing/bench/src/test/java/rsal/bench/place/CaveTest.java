package rsal.bench.place;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.settings.FileSource;
import rsal.settings.Location;

class CaveTest {
    private static final Path IMAGE = Path.of("../../middle/worlds/src/main/resources/rsal/maps/cave.png");

    /// `-Drsal.update=true` draws it anew.
    @Test
    void theMapThatComesWithTheProgramIsWhatIsDrawn() throws IOException {
        OccupancyGrid drawn = Cave.draw(128, 0.05, 1);
        if (Boolean.getBoolean("rsal.update")) {
            ImageIO.write(image(drawn), "png", IMAGE.toFile());
        }
        OccupancyGrid shipped = new Maps(FileSource.folder(Path.of("../../middle/worlds/src/main/resources/rsal/maps")))
                .read("cave.yaml", Location.of("test"));
        assertThat(shipped.cells()).isEqualTo(drawn.cells());
        assertThat(shipped.resolution()).isEqualTo(drawn.resolution());
        assertThat(shipped.originX()).isEqualTo(drawn.originX());
        assertThat(shipped.originY()).isEqualTo(drawn.originY());
    }

    private static BufferedImage image(OccupancyGrid map) {
        var image = new BufferedImage(map.width(), map.height(), BufferedImage.TYPE_BYTE_GRAY);
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                int gray = map.at(column, row) == OccupancyGrid.FREE ? 254 : 0;
                image.getRaster().setSample(column, map.height() - 1 - row, 0, gray);
            }
        }
        return image;
    }
}
