package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.mcap.McapFile;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;

class CsvExportTest {
    private static final String SCENARIO = "find-and-collect";

    @TempDir
    static Path folder; // of one export, which all tests look at

    @BeforeAll
    static void export() throws Exception {
        export(folder);
    }

    @LongTest
    @Test
    void exportsToAFolderOfWindows() throws Exception {
        try (FileSystem windows = Jimfs.newFileSystem(Configuration.windows())) {
            export(Files.createDirectories(windows.getPath("C:\\Users\\Bob\\my tables")));
        }
    }

    private static void export(Path folder) throws Exception {
        Path recording = folder.resolve("run.mcap");
        Recorded.run(Recorded.plan(SCENARIO, 1, 20), recording);
        try (McapFile file = McapFile.open(recording)) {
            var export = new CsvExport(file);
            assertThat(export.write(folder).stream()
                            .map(path -> path.getFileName().toString()))
                    .containsExactlyElementsOf(export.names());
        }
    }

    @Test
    void writesTheTablesOfChosenTopicsOnly() throws Exception {
        Path chosen = folder.resolve("chosen");
        try (McapFile file = McapFile.open(folder.resolve("run.mcap"))) {
            var export = new CsvExport(file);
            assertThat(export.topics()).contains("/state", "/events", "/map");
            export.keep(List.of("/events"));
            assertThat(export.write(chosen)).containsExactly(chosen.resolve("events.csv"));
        }
        assertThat(chosen.resolve("events.csv")).hasSameBinaryContentAs(folder.resolve("events.csv"));
    }

    @Test
    void eachParticleIsARow() throws Exception {
        List<Map<String, String>> rows = table("explorer-1.particles.csv");
        assertThat(rows.getFirst().keySet()).containsExactly("log_time_s", "frame_id", "x", "y", "heading", "weight");
        Map<String, Double> weights = new LinkedHashMap<>(); // of all at once
        rows.forEach(row -> weights.merge(row.get("log_time_s"), Double.parseDouble(row.get("weight")), Double::sum));
        assertThat(weights).hasSizeGreaterThan(5);
        assertThat(weights.values()).allSatisfy(sum -> assertThat(sum).isCloseTo(1, within(1e-3)));
    }

    @Test
    void eachPointOfAPathIsARow() throws Exception {
        assertThat(table("explorer-1.local_path.csv")).hasSizeGreaterThan(20);
        List<Map<String, String>> rows = table("explorer-1.path.csv");
        assertThat(rows.getFirst().keySet()).containsExactly("log_time_s", "frame_id", "point", "x", "y");
        List<Map<String, String>> points =
                rows.stream().filter(row -> !row.get("point").isEmpty()).toList();
        assertThat(points).isNotEmpty();
        for (int i = 1; i < points.size(); i++) {
            Map<String, String> before = points.get(i - 1);
            Map<String, String> here = points.get(i);
            boolean isSamePath = before.get("log_time_s").equals(here.get("log_time_s"));
            assertThat(here.get("point"))
                    .isEqualTo(isSamePath ? Integer.toString(Integer.parseInt(before.get("point")) + 1) : "0");
        }
    }

    @Test
    void stateHasARowForEachRobotAndNothingThatIsNoNumberOrWordIsWritten() throws Exception {
        List<Map<String, String>> rows = table("state.csv");
        assertThat(rows).extracting(row -> row.get("robots.id")).contains("collector-1", "collector-2");
        assertThat(folder.resolve("world.csv")).doesNotExist();
        assertThat(folder.resolve("things.csv")).doesNotExist();
    }

    @Test
    void eachLinkIsARow() throws Exception {
        List<Map<String, String>> rows = table("links.csv");
        assertThat(rows).anySatisfy(row -> {
            assertThat(row.get("links.one")).isNotEmpty().isNotEqualTo(row.get("links.other"));
            assertThat(row.get("links.said_there")).isEqualTo("true");
        });
        assertThat(rows).allMatch(row -> row.get("too_many").equals("false"));
    }

    @Test
    void whatDevicesReportedHasATableForEachOfThem() throws Exception {
        List<Map<String, String>> grippers = table("collector-1.device.gripper.csv");
        assertThat(grippers).hasSizeGreaterThan(100).allSatisfy(row -> {
            assertThat(row.get("paddles")).isIn("OPEN", "OPENING");
            assertThat(row.get("holding")).isEqualTo("false");
        });
        assertThat(table("explorer-1.device.navigator.csv"))
                .anySatisfy(row -> assertThat(row.get("goal.x")).isNotEmpty());
        assertThat(table("explorer-1.device.camera.csv"))
                .anySatisfy(row -> assertThat(row.get("blobs.color")).isEmpty())
                .anySatisfy(row -> assertThat(row.get("blobs.color")).startsWith("#"));
        assertThat(table("explorer-1.device.pilot.csv").getFirst()).containsKeys("twist.vx", "in_charge", "opinions");
    }

    @Test
    void theWorldsMapIsWrittenAsRosReadsIt() throws Exception {
        OccupancyGrid reported = Recorded.plan(SCENARIO, 1, 20).map();
        OccupancyGrid read = new Maps(FileSource.folder(folder)).read("map.yaml", Location.of("test"));
        assertThat(read.cells()).isEqualTo(reported.cells());
        assertThat(read.resolution()).isEqualTo(reported.resolution());
        assertThat(read.originX()).isEqualTo(reported.originX());
        assertThat(table("map.csv")).hasSize(1);
    }

    private List<Map<String, String>> table(String name) throws Exception {
        List<String> lines = Files.readAllLines(folder.resolve(name));
        String[] columns = lines.getFirst().split(",", -1);
        var rows = new ArrayList<Map<String, String>>();
        for (String line : lines.subList(1, lines.size())) {
            String[] cells = line.split(",", -1);
            var row = new LinkedHashMap<String, String>();
            for (int i = 0; i < columns.length; i++) {
                row.put(columns[i], i < cells.length ? cells[i] : "");
            }
            rows.add(row);
        }
        return rows;
    }
}
