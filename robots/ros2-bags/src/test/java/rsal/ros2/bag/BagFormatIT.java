package rsal.ros2.bag;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.github.luben.zstd.ZstdInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Arrays;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogFormat;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.RobotLog;
import rsal.testkit.OfficialPython;
import rsal.testkit.Rounds;
import rsal.testkit.Trials;

/// Bags that rosbags has written, which is none of ours.
class BagFormatIT {
    private static final float INF = Float.POSITIVE_INFINITY;
    private static final float NEAR = Float.NEGATIVE_INFINITY;
    private static final float[] RANGES = {1, 2, 3, 4, 5, INF, Float.NaN, NEAR, INF};
    private static final Offset<Double> EXACT = within(1e-6);

    @TempDir
    private Path folder;

    /// @param kind `odom`: with odometry; `tf`: with TF alone; `down`: the laser is upside down; `clockwise`: it turns
    /// so
    private Path bag(String kind) throws Exception {
        return bag(kind, "mcap/");
    }

    /// @param storage of what and how it is compressed: `sqlite3/file`
    private Path bag(String kind, String storage) throws Exception {
        Path bag = folder.resolve(kind);
        try (var script = Objects.requireNonNull(getClass().getResourceAsStream("/bag.py"))) {
            OfficialPython.run(
                    new String(script.readAllBytes(), StandardCharsets.UTF_8), kind, bag.toString(), storage);
        }
        return bag;
    }

    private static float[] reversed(float[] ranges) {
        var reversed = new float[ranges.length];
        for (int i = 0; i < ranges.length; i++) {
            reversed[i] = ranges[ranges.length - 1 - i];
        }
        return reversed;
    }

    @ParameterizedTest
    @ValueSource(strings = {"odom", "tf"})
    void scansAndOdometryAreRead(String kind) throws Exception {
        RobotLog log = LogFormats.read(bag(kind), LaserHints.DEFAULT);
        assertThat(log.scans()).hasSize(20);
        assertThat(log.motions()).hasSize(20);
        Motion motion = log.motions().get(3);
        assertThat(motion.time()).isEqualTo(Instant.ofEpochMilli(1300));
        assertThat(motion.odomFromBase().x()).isCloseTo(0.15, EXACT);
        assertThat(motion.odomFromBase().theta()).isCloseTo(0.3, EXACT);
        assertThat(motion.speed()).isEqualTo(kind.equals("odom") ? 0.5 : 0);
        LaserScan scan = log.scans().get(3).scan();
        assertThat(log.scans().get(3).time()).isEqualTo(Instant.ofEpochMilli(1300));
        assertThat(scan.baseFromLaser().isNear(new Pose2d(0.25, 0.05, 0.5), 1e-6, 1e-6))
                .isTrue();
        assertThat(scan.angleMin()).isEqualTo(-1);
        assertThat(scan.angleIncrement()).isEqualTo(0.25);
        assertThat(Arrays.toString(scan.ranges())).isEqualTo(Arrays.toString(RANGES));
        assertThat(log.scans().get(3).broken()).isEqualTo(1);
    }

    /// Also those that recorders of Humble and Lyrical have as tables, with an image of 3 MB that nobody asks for.
    @Trials(
            value = {
                "mcap/lz4",
                "mcap/file",
                "sqlite3/",
                "sqlite3/file",
                "mcap/message",
                "sqlite3/message",
                "sqlite3/humble",
                "sqlite3/lyrical",
                "sqlite3/utf16"
            },
            landing = 4)
    void storageAndCompressionMakeNoDifference(String storage) throws Exception {
        RobotLog plain = LogFormats.read(bag("odom"), LaserHints.DEFAULT);
        Path other = Files.createDirectory(folder.resolve("other")).resolve("odom");
        Files.move(folder.resolve("odom"), other);
        Path bag = bag("odom", storage);
        RobotLog read = LogFormats.read(bag, LaserHints.DEFAULT);
        assertThat(read.motions()).isEqualTo(plain.motions());
        assertThat(read.scans().stream().map(String::valueOf).map(BagFormatIT::withoutHash))
                .isEqualTo(plain.scans().stream()
                        .map(String::valueOf)
                        .map(BagFormatIT::withoutHash)
                        .toList());
        assertThat(read.skipped().total()).isZero();
        Path file = only(bag);
        RobotLog alone = LogFormats.read(file, LaserHints.DEFAULT);
        assertThat(alone.motions()).isEqualTo(plain.motions());
        LogFormat format = LogFormats.installed().stream()
                .filter(each -> !each.suffix().isEmpty() && file.toString().contains(each.suffix()))
                .findFirst()
                .orElseThrow();
        try (var in = Files.newInputStream(file)) {
            assertThat(LogFormats.read(format, file.toString(), in, LaserHints.DEFAULT)
                            .motions())
                    .isEqualTo(plain.motions());
        }
    }

    private static String withoutHash(String scan) {
        return scan.replaceAll("\\[F@\\w+", "");
    }

    private static Path only(Path bag) throws IOException {
        try (Stream<Path> files = Files.list(bag)) {
            return files.filter(file -> !file.endsWith("metadata.yaml"))
                    .findFirst()
                    .orElseThrow();
        }
    }

    /// As when the recorder was killed.
    @Test
    void aDatabaseThatWasNotClosedIsRefused() throws Exception {
        Path bag = bag("odom", "sqlite3/open");
        assertThatThrownBy(() -> LogFormats.read(bag, LaserHints.DEFAULT))
                .isInstanceOf(BrokenLog.class)
                .hasMessageContainingAll("was not closed", "odom.db3-wal", "sqlite3");
    }

    @Test
    void aDatabaseOfSomethingElseIsRefused() throws Exception {
        Path file = folder.resolve("other.db3");
        OfficialPython.run(
                "import sqlite3, sys\nd = sqlite3.connect(sys.argv[1])\nd.execute('CREATE TABLE a(b)')\nd.commit()",
                file.toString());
        assertThatThrownBy(() -> LogFormats.read(file, LaserHints.DEFAULT))
                .isInstanceOf(BrokenLog.class)
                .hasMessageContaining("no table 'messages'");
    }

    @Test
    void aFolderOfTwoStoragesIsRefused() throws Exception {
        Path bag = bag("odom");
        Files.copy(bag.resolve("odom.mcap"), bag.resolve("odom.db3"));
        assertThatThrownBy(() -> LogFormats.read(bag, LaserHints.DEFAULT))
                .isInstanceOf(BrokenLog.class)
                .hasMessageContaining("Name the file");
    }

    /// Players of ROS leave the decompressed file beside the other one.
    @Test
    void aFileThatIsThereInBothFormsCountsOnce() throws Exception {
        Path bag = bag("odom", "sqlite3/file");
        try (var zstd = new ZstdInputStream(Files.newInputStream(bag.resolve("odom.db3.zstd")))) {
            Files.copy(zstd, bag.resolve("odom.db3"));
        }
        assertThat(LogFormats.read(bag, LaserHints.DEFAULT).scans()).hasSize(20);
    }

    /// As the laser's z axis points down, its beams go clockwise when seen from above.
    @Test
    void aLaserThatIsMountedUpsideDownIsTurned() throws Exception {
        LaserScan scan = LogFormats.read(bag("down"), LaserHints.DEFAULT)
                .scans()
                .getFirst()
                .scan();
        assertThat(Arrays.toString(scan.ranges())).isEqualTo(Arrays.toString(reversed(RANGES)));
        assertThat(scan.angleMin()).isCloseTo(-1, EXACT); // its last beam, at +1 in its own frame
        assertThat(scan.baseFromLaser().theta()).isCloseTo(0.5, EXACT);
    }

    @Test
    void aLaserThatTurnsClockwiseIsReversed() throws Exception {
        LaserScan scan = LogFormats.read(bag("clockwise"), LaserHints.DEFAULT)
                .scans()
                .getFirst()
                .scan();
        assertThat(Arrays.toString(scan.ranges())).isEqualTo(Arrays.toString(reversed(RANGES)));
        assertThat(scan.angleMin()).isEqualTo(-1);
        assertThat(scan.angleIncrement()).isEqualTo(0.25);
    }

    @Test
    void aFileAloneIsABagAndSoIsAStreamOfIt() throws Exception {
        Path file = bag("odom").resolve("odom.mcap");
        assertThat(LogFormats.read(file, LaserHints.DEFAULT).scans()).hasSize(20);
        assertThat(LogFormats.read(
                                new McapBagFormat(),
                                "odom.mcap",
                                new ByteArrayInputStream(Files.readAllBytes(file)),
                                LaserHints.DEFAULT)
                        .motions())
                .hasSize(20);
    }

    @Test
    void whatIsNoBagIsRefused() throws Exception {
        Path file = Files.writeString(folder.resolve("text.mcap"), "FLASER 180");
        assertThatThrownBy(() -> LogFormats.read(file, LaserHints.DEFAULT)).isInstanceOf(BrokenLog.class);
        Path empty = Files.createDirectory(folder.resolve("empty"));
        assertThatThrownBy(() -> LogFormats.read(empty, LaserHints.DEFAULT))
                .isInstanceOf(BrokenLog.class)
                .hasMessageContaining("There is no log in this folder.");
    }

    /// What is damaged is read as far as it goes, or refused.
    @Test
    void damagedBagsBreakNothing() throws Exception {
        damage(Files.readAllBytes(only(bag("odom"))), "damaged.mcap");
    }

    @Trials(
            value = {"mcap/file", "sqlite3/file", "sqlite3/", "sqlite3/message", "mcap/lz4"},
            landing = 3)
    void damagedBagsOfOtherStoragesBreakNothing(String storage) throws Exception {
        Path file = only(bag("odom", storage));
        damage(
                Files.readAllBytes(file),
                "damaged" + file.getFileName().toString().substring("odom".length()));
    }

    private void damage(byte[] whole, String name) throws Exception {
        var random = new SplittableRandom(3);
        for (int i = 0; i < Rounds.of(20, 3_000); i++) {
            byte[] bytes = Arrays.copyOf(whole, random.nextBoolean() ? whole.length : random.nextInt(whole.length));
            for (int k = random.nextInt(6); k > 0 && bytes.length > 0; k--) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
            }
            Path file = Files.write(folder.resolve(name), bytes);
            try {
                assertThat(LogFormats.read(file, LaserHints.DEFAULT).scans().size())
                        .isLessThanOrEqualTo(20);
            } catch (BrokenLog e) {
                assertThat(e).hasMessageContaining(name);
            }
        }
    }
}
