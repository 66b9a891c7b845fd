package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Logs of one drive through a house of 12.3 m × 8.35 m, each with a fault that real logs have. Without it, the map
/// has 250 × 171 cells of 0.05 m and 93 m² of free floor.
class MapTest {
    @TempDir
    private Path folder;

    private record Mapped(JsonNode result, String err, OccupancyGrid grid) {
        double freeFloor() {
            int free = 0;
            for (byte cell : grid.cells()) {
                free += cell == OccupancyGrid.FREE ? 1 : 0;
            }
            return free * grid.resolution() * grid.resolution();
        }

        double worstStep() {
            return result.at("/residual/all/deviations").asDouble(Double.NaN);
        }

        void assertWhole() {
            assertThat(grid.width()).isCloseTo(250, within(2));
            assertThat(grid.height()).isCloseTo(171, within(2));
            assertThat(freeFloor()).isCloseTo(93, within(1.0));
        }
    }

    private Mapped map(String log, String... options) throws IOException {
        Path file = folder.resolve(log + ".log.gz");
        try (InputStream in = Objects.requireNonNull(MapTest.class.getResourceAsStream("logs/" + log + ".log.gz"))) {
            Files.write(file, in.readAllBytes());
        }
        Path map = folder.resolve("map");
        var line =
                new ArrayList<>(List.of("map", file.toString(), "--out", map.toString(), "--no-reference", "--json"));
        line.addAll(List.of(options));
        var out = new ByteArrayOutputStream();
        var err = new StringWriter();
        var rsal = Main.commandLine(out);
        rsal.setErr(new PrintWriter(err, true));
        assertThat(rsal.execute(line.toArray(String[]::new))).isEqualTo(Exit.SUCCESS);
        rsal.getOut().flush();
        return new Mapped(
                JsonMapper.shared().readTree(out.toString(StandardCharsets.UTF_8)),
                err.toString(),
                new Maps(FileSource.folder(map)).read("map.yaml", Location.of("map.yaml")));
    }

    @Test
    void beamsThatHitNothingDrawNoFreeFloorThroughWalls() throws IOException {
        Mapped mapped = map("max8191");
        mapped.assertWhole();
        assertThat(mapped.err().lines())
                .as("nothing but the progress, which a slow machine shows")
                .allMatch(line -> line.matches(
                        ".*/max8191\\.log\\.gz: \\d+ of 643 scans, \\d+ kept, \\d+ places known again so far"));
    }

    @Test
    @LongTest
    void beamsThatHitNothingDrawFreeFloorWhenAskedTo() throws IOException {
        assertThat(map("max8191", "--free-range", "10").freeFloor()).isGreaterThan(300);
    }

    /// 44 s without a scan, in which the robot drove into a room that looks like the one it left.
    @Test
    @LongTest
    void odometryBridgesAGapInTheLog() throws IOException {
        Mapped mapped = map("gap");
        mapped.assertWhole();
        assertThat(mapped.worstStep()).isLessThan(1);
    }

    @Test
    void odometryThatLeapsIsNamedAndTakenOut() throws IOException {
        Mapped mapped = map("odomreset");
        mapped.assertWhole();
        assertThat(mapped.err())
                .contains("odomreset.log.gz' jumps once.", "odomreset.log.gz:301: 7.71 m and 90° in 0.20 s");
        assertThat(mapped.worstStep()).isLessThan(2);
    }
}
