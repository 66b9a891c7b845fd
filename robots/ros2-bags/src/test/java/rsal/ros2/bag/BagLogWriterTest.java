package rsal.ros2.bag;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogEntry.Scan;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.LogWriter;
import rsal.navigation.log.RobotLog;
import rsal.navigation.replay.RecordedDrive;
import rsal.navigation.replay.RecordedDrive.Stop;

/// From CARMEN to a bag and back.
class BagLogWriterTest {
    private static final double EXACT = 1e-6; // m, rad

    @TempDir
    private Path folder;

    private RobotLog log;

    @BeforeEach
    void read() throws Exception {
        Path file = Files.writeString(folder.resolve("lab.log"), CarmenText.of(40, false));
        log = LogFormats.read(file, LaserHints.DEFAULT);
        assertThat(log.scans()).hasSize(40);
    }

    private RobotLog written(RobotLog written, String name) throws Exception {
        Path target = folder.resolve(name);
        LogWriter writer = LogFormats.writers().stream()
                .filter(each -> each.accepts(name))
                .findFirst()
                .orElseThrow();
        assertThat(writer.write(written, target, false).scans()).isEqualTo(40);
        return LogFormats.read(target, LaserHints.DEFAULT);
    }

    @ParameterizedTest
    @ValueSource(strings = {"bag/", "bag.mcap", "again.log"})
    void posesScansAndTimesAreKept(String name) throws Exception {
        compare(written(log, name));
        compare(written(written(log, "other" + name), "back.log"));
    }

    private void compare(RobotLog other) {
        assertThat(other.skipped().total()).isZero();
        RecordedDrive expected = RecordedDrive.of(log);
        RecordedDrive drive = RecordedDrive.of(other);
        assertThat(drive.stops()).hasSize(40);
        for (int i = 0; i < 40; i++) {
            Stop stop = expected.stops().get(i);
            Stop read = drive.stops().get(i);
            assertThat(read.time()).isEqualTo(stop.time());
            assertThat(read.odomFromBase().isNear(stop.odomFromBase(), EXACT, EXACT))
                    .as("%s, not %s", read.odomFromBase(), stop.odomFromBase())
                    .isTrue();
            assertThat(Arrays.toString(read.scan().ranges()))
                    .isEqualTo(Arrays.toString(stop.scan().ranges()));
            assertThat(read.scan().angleMin()).isEqualTo(stop.scan().angleMin());
            assertThat(read.scan().angleIncrement()).isEqualTo(stop.scan().angleIncrement());
        }
        assertThat(other.motions().getLast().speed()).isEqualTo(0.4);
        assertThat(other.motions().getLast().turnRate()).isEqualTo(0.04);
    }

    @Test
    void theMountOfTheLaserIsKept() throws Exception {
        String text = "PARAM robot_frontlaser_offset 0.2\n"
                + CarmenText.of(40, false)
                        .replaceAll(
                                "(?m)^ROBOTLASER1 (.*? 0) \\S+ \\S+ \\S+ \\S+ \\S+ \\S+ 0 0 0 0 0 ", "RAWLASER1 $1 ");
        Path file = Files.writeString(folder.resolve("mounted.log"), text);
        log = LogFormats.read(file, LaserHints.DEFAULT);
        for (String name : new String[] {"mounted/", "mounted2.log"}) {
            Scan scan = written(log, name).scans().getFirst();
            assertThat(scan.scan().baseFromLaser().x()).isBetween(0.2 - EXACT, 0.2 + EXACT);
        }
    }

    @Test
    void equalLogsAreEqualBytes() throws Exception {
        Files.createDirectory(folder.resolve("one"));
        Files.createDirectory(folder.resolve("two"));
        written(log, "one/bag/");
        written(log, "two/bag/");
        for (String file : new String[] {"bag/bag_0.mcap", "bag/metadata.yaml"}) {
            assertThat(folder.resolve("one").resolve(file))
                    .hasSameBinaryContentAs(folder.resolve("two").resolve(file));
        }
    }

    @Test
    void aBagThatIsThereIsKept() throws Exception {
        Path bag = folder.resolve("bag");
        new BagLogWriter().write(log, bag, false);
        assertThatThrownBy(() -> new BagLogWriter().write(log, bag, false))
                .isInstanceOf(FileAlreadyExistsException.class);
        new BagLogWriter().write(log, bag, true);
        assertThat(LogFormats.read(bag, LaserHints.DEFAULT).scans()).hasSize(40);
    }
}
