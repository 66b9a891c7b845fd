package rsal.navigation.carmen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogEntry;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Parameter;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;
import rsal.navigation.log.RobotLog;
import rsal.navigation.log.Skipped;

class CarmenReaderTest {
    private final List<LogEntry> entries = new ArrayList<>();

    @Test
    void readsOdometryParametersAndScansInTheirOrder() throws IOException {
        Skipped skipped = read("""
                # comments say nothing
                PARAM robot_front_laser_max 80.99 nohost 0
                ODOM 1.5 -2 0.5 0.3 -0.1 0 976052857.25 host 3.25
                FLASER 3 1.5 2.5 3.5 1 2 0.5 1 2 0.5 976052857.5 host 3.5
                NEFF 60
                """);

        assertThat(entries.get(0)).isEqualTo(new Parameter(2, "robot_front_laser_max", "80.99 nohost 0"));
        assertThat(entries.get(1))
                .isEqualTo(new Motion(
                        3, Instant.ofEpochSecond(976052857, 250_000_000), new Pose2d(1.5, -2, 0.5), 0.3, -0.1));
        Scan scan = scans().getFirst();
        assertThat(scan.line()).isEqualTo(4);
        assertThat(scan.time()).isEqualTo(Instant.ofEpochSecond(976052857, 500_000_000));
        assertThat(scan.scan().ranges()).containsExactly(1.5f, 2.5f, 3.5f);
        assertThat(scan.poses()).isEqualTo(new Poses.Reported(new Pose2d(1, 2, 0.5), new Pose2d(1, 2, 0.5)));
        assertThat(skipped.total()).isZero();
        assertThat(skipped.otherKinds()).isEqualTo(2);
    }

    @Test
    void theReadingsOfALaserThatIsUpsideDownBeginAtTheLeft() throws IOException {
        String log = """
                FLASER 4 1 2 3 4 0 0 0 0 0 0 1 h 0
                ROBOTLASER1 0 -0.5 2 1 20 0.01 0 3 1 2 3 0 0 0 0 0 0 0 0 0 0.3 0.3 0.5 2 h 0
                """;
        read(bytes(log), new LaserHints(Math.PI, 50, true, Optional.empty()));

        var plain = scans().getFirst().scan();
        assertThat(plain.ranges()).containsExactly(4, 3, 2, 1);
        assertThat(Math.toDegrees(plain.angle(3))).isCloseTo(90, within(1e-9));
        var configured = scans().get(1).scan();
        assertThat(configured.ranges()).containsExactly(3, 2, 1);
        assertThat(configured.angle(2)).isCloseTo(0.5, within(1e-9));
        assertThat(configured.angle(0)).isCloseTo(-1.5, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"180, 1, 89", "181, 1, 90", "360, 0.5, 89.5", "361, 0.5, 90"})
    void theReadingsOfAPlainScanBeginAtTheRight(int count, double stepDegrees, double lastDegrees) throws IOException {
        read(flaser(count, 2));

        var scan = scans().getFirst().scan();
        assertThat(Math.toDegrees(scan.angle(0))).isCloseTo(-90, within(1e-9));
        assertThat(Math.toDegrees(scan.angleIncrement())).isCloseTo(stepDegrees, within(1e-9));
        assertThat(Math.toDegrees(scan.angle(count - 1))).isCloseTo(lastDegrees, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(strings = {"81.91", "81.83", "51.15", "50", "32.767", "8.191", "8.187", "inf", "1e30"})
    void whatStandsForNothingIsNoHit(String reading) throws IOException {
        read("FLASER 2 %s 3 0 0 0 0 0 0 1 h 1".formatted(reading));

        assertThat(scans().getFirst().scan().ranges()).containsExactly(Float.POSITIVE_INFINITY, 3);
        assertThat(scans().getFirst().broken()).isZero();
    }

    @Test
    void whatIsNoLengthIsBrokenAndCounted() throws IOException {
        read("FLASER 5 nan -1 0 -inf 3 0 0 0 0 0 0 1 h 1");

        assertThat(scans().getFirst().scan().ranges())
                .containsExactly(Float.NaN, Float.NaN, Float.NEGATIVE_INFINITY, Float.NaN, 3);
        assertThat(scans().getFirst().broken()).isEqualTo(4);
    }

    @Test
    void readsALaserThatGivesItsAnglesAndMount() throws IOException {
        read("ROBOTLASER1 0 -1.0 2.0 0.5 20 0.01 0 5 1 2 3 25 4 2 7 8 1.2 1 0 1 1 0 0 0 0 0 0 12 h 13");

        Scan scan = scans().getFirst();
        assertThat(scan.scan().angle(4)).isCloseTo(1.0, within(1e-12));
        assertThat(scan.scan().ranges()).containsExactly(1, 2, 3, Float.POSITIVE_INFINITY, 4);
        assertThat(scan.scan().baseFromLaser().x()).isCloseTo(0.2, within(1e-12));
        assertThat(scan.poses()).isEqualTo(new Poses.Reported(new Pose2d(1, 1, 0), new Pose2d(1, 1, 0)));
        assertThat(scan.time()).isEqualTo(Instant.ofEpochSecond(12));
    }

    @Test
    void aRawLaserDoesNotSayWhereItWas() throws IOException {
        read("RAWLASER1 0 -1.570796 3.141593 0.5 81.9 0.01 0 3 1 2 3 0 12 h 13");

        assertThat(scans().getFirst().poses()).isEqualTo(new Poses.Unknown());
    }

    @Test
    void aRawLaserIsMountedWhereTheParametersBeforeItSay() throws IOException {
        String scan = "RAWLASER1 0 -1.570796 3.141593 0.5 81.9 0.01 0 3 1 2 3 0 12 h 13\n";
        Skipped skipped = read(scan
                + "PARAM robot_frontlaser_offset 0.25\n"
                + scan
                + "PARAM robot_frontlaser_side_offset -0.1 0 nohost 0\n"
                + "PARAM robot_frontlaser_angular_offset 0.5 0 nohost 0\n"
                + "PARAM robot_rearlaser_offset -0.4 0 nohost 0\n"
                + scan);

        assertThat(skipped.total()).isZero();
        assertThat(scans().stream().map(s -> s.scan().baseFromLaser()))
                .containsExactly(Pose2d.ORIGIN, new Pose2d(0.25, 0, 0), new Pose2d(0.25, -0.1, 0.5));
    }

    @Test
    void scansWithPosesAreNotMountedByParameters() throws IOException {
        String mount = "PARAM robot_frontlaser_offset 0.25\nPARAM robot_frontlaser_angular_offset 0.5\n";

        read(mount + "ROBOTLASER1 0 -0.5 2 1 20 0.01 0 3 1 2 3 0 1.2 1 0 1 1 0 0 0 0.3 0.3 0.5 12 h 0\n");
        assertThat(scans().getFirst().scan().baseFromLaser().isNear(new Pose2d(0.2, 0, 0), 1e-9, 1e-9))
                .isTrue();

        read(mount + "FLASER 1 1 1 2 0 1 2 0 12 h 1\n");
        assertThat(scans().getFirst().scan().baseFromLaser()).isEqualTo(Pose2d.ORIGIN);
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "robot_frontlaser_offset front | not a number | 'front'",
                "robot_frontlaser_offset nan | not finite | 'NaN'",
                "robot_frontlaser_offset | cut short | ends",
                "robot_frontlaser_side_offset 250 nohost 0 | an impossible mount | '250.0', not -1.5 to 1.5 m",
                "robot_frontlaser_angular_offset 180 | an impossible mount | '180.0', not -6.3 to 6.3 rad"
            })
    void aMountThatCannotBeIsReportedAndNotUsed(String parameter, String reason, String reported) throws IOException {
        Skipped skipped = read("PARAM robot_frontlaser_offset 0.2\nPARAM " + parameter
                + "\nRAWLASER1 0 -1.570796 3.141593 0.5 81.9 0.01 0 3 1 2 3 0 12 h 13\n");

        assertThat(skipped.counts()).containsOnlyKeys(reason);
        assertThat(skipped.first().getFirst().what()).contains(parameter.split(" ", 2)[0], reported, "not used");
        assertThat(scans().getFirst().scan().baseFromLaser()).isEqualTo(new Pose2d(0.2, 0, 0));
    }

    @Test
    void aLaserOfAPlainScanIsMovedAheadButACorrectedPoseIsNoMount() throws IOException {
        read("FLASER 1 1 1.1 2 0 1 2 0 1 h 1");
        assertThat(scans().getFirst().scan().baseFromLaser().x()).isCloseTo(0.1, within(1e-12));

        read("FLASER 1 1 1.3 2.4 0.2 1 2 0 2 h 2");
        assertThat(scans().getFirst().scan().baseFromLaser()).isEqualTo(Pose2d.ORIGIN);
        assertThat(scans().getFirst().poses())
                .isEqualTo(new Poses.Reported(new Pose2d(1, 2, 0), new Pose2d(1.3, 2.4, 0.2)));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "FLASER 4 1 2 3 0 0 0 0 0 0 1 h 1     | not a number",
                "FLASER 9 1 2 3 0 0 0 0 0 0 1 1 1     | cut short",
                "FLASER 2 1 2 3 0 0 0 0 0 0 1 1 1     | a count that is not that of its readings",
                "FLASER -1 1 0 0 0 0 0 0 1 h 1        | an impossible count",
                "FLASER 2000000000 1 0 0 0 0 0 0 1 h 1| an impossible count",
                "FLASER 0 0 0 0 0 0 0 1 h 1           | no readings",
                "FLASER 2 0 nan 0 0 0 0 0 0 1 h 1     | nothing measured",
                "FLASER 1 1 nan 0 0 0 0 0 1 h 1       | not finite",
                "FLASER 1 1 0 0 0 1e300 0 0 1 h 1     | an impossible pose",
                "FLASER 1 1 0 0 0 0 0 0 inf h 1       | not finite",
                "ROBOTLASER1 0 0 1 1 -5 0 0 1 1 0 0 0 0 0 0 0 0 0 0 0 0 1 h 1 | an impossible laser",
                "RAWLASER1 0 0 -5 -5 20 0 0 4 1 2 3 4 0 1 h 1 | an impossible laser",
                "ODOM 0 0 nan 0 0 0 1 h 1             | not finite",
                "ODOM 0 0 O 0 0 0 1 h 1               | not a number"
            })
    void whatDoesNotSayWhatItsKindPromisesIsSkippedAndCounted(String line, String reason) throws IOException {
        Skipped skipped = read("PARAM a b\n" + line + "\nPARAM c d\n");

        assertThat(entries).hasSize(2);
        assertThat(skipped.counts()).containsOnlyKeys(reason);
        assertThat(skipped.first())
                .singleElement()
                .extracting(Skipped.Place::line)
                .isEqualTo(2);
    }

    @Test
    void aLastLineThatWasCutShortIsSkipped() throws IOException {
        assertThat(read("ODOM 0 0 0 0 0 0 1 h 1\nODOM 1 0 0 0 ").counts()).containsOnlyKeys("cut short");
    }

    @Test
    void whatGoesBackInTimeIsSkippedUntilTheClockHasClearlyBeenSetBack() throws IOException {
        String log = IntStream.of(10, 12, 11, 13, 2, 3, 4, 5, 6)
                .mapToObj("ODOM 0 0 0 0 0 0 %d h 0\n"::formatted)
                .collect(Collectors.joining());

        Skipped skipped = read(log);

        assertThat(entries.stream().map(e -> ((Motion) e).time().getEpochSecond()))
                .containsExactly(10L, 12L, 13L, 5L, 6L);
        assertThat(skipped.counts()).isEqualTo(java.util.Map.of("back in time", 4));
        assertThat(skipped.first().getFirst().what()).contains("11.0").contains("12.0");
    }

    @Test
    void aMessageWithoutATimeHasThatOfTheOneBefore() throws IOException {
        read("""
                ODOM 0 0 0 0 0 0 0 h 0
                ODOM 0 0 0 0 0 0 0 h 5
                ODOM 0 0 0 0 0 0 7 h 0
                ODOM 0 0 0 0 0 0 0 h 6
                """);

        assertThat(entries.stream().map(e -> ((Motion) e).time().getEpochSecond()))
                .containsExactly(0L, 5L, 5L, 6L);
    }

    @Test
    void readsWhatGzipPacked() throws IOException {
        read(gzip(flaser(180, 2)), LaserHints.DEFAULT);

        assertThat(scans()).hasSize(1);
    }

    @Test
    void aPackedFileThatWasCutShortIsBrokenAtItsLine() throws IOException {
        byte[] packed = gzip(
                IntStream.range(0, 500).mapToObj(i -> flaser(180, 1 + i * 0.01)).collect(Collectors.joining("\n")));
        byte[] cut = Arrays.copyOf(packed, packed.length / 2);

        assertThatThrownBy(() -> read(cut, LaserHints.DEFAULT))
                .isInstanceOf(BrokenLog.class)
                .hasMessageMatching("test\\.log:\\d+: The packed file ends early.*");
        assertThat(entries).isNotEmpty();
    }

    @Test
    void aDamagedPackedFileIsBroken() throws IOException {
        byte[] packed = gzip(flaser(360, 2) + "\n" + flaser(360, 3));
        packed[packed.length - 5] ^= 0x55; // of the checksum

        assertThatThrownBy(() -> read(packed, LaserHints.DEFAULT))
                .isInstanceOf(BrokenLog.class)
                .hasMessageContaining("damaged");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "resolution: 0.05\nimage: a.pgm\n", "\u0000\u0001\u0002"})
    void whatIsNoLogIsSaidToBeNone(String text) {
        assertThatThrownBy(() -> read(text)).isInstanceOf(BrokenLog.class).hasMessageContaining("no message of CARMEN");
    }

    @Test
    void aLineWithoutEndIsRefused() {
        assertThatThrownBy(() -> read("PARAM a b\nFLASER " + "1 ".repeat(1 << 20)))
                .isInstanceOf(BrokenLog.class)
                .hasMessageStartingWith("test.log:2:");
    }

    private Skipped read(String text) throws IOException {
        return read(bytes(text), LaserHints.DEFAULT);
    }

    private Skipped read(byte[] file, LaserHints hints) throws IOException {
        entries.clear();
        var collector = new LogCollector("test.log", hints);
        try {
            CarmenReader.read("test.log", new ByteArrayInputStream(file), hints, collector);
        } finally {
            RobotLog log = collector.log();
            Stream.of(log.parameters(), log.motions(), log.scans())
                    .flatMap(List::stream)
                    .sorted(Comparator.comparingInt(LogEntry::line))
                    .forEach(entries::add);
        }
        return collector.log().skipped();
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private List<Scan> scans() {
        return entries.stream()
                .filter(Scan.class::isInstance)
                .map(Scan.class::cast)
                .toList();
    }

    static String flaser(int count, double range) {
        return "FLASER " + count + (" " + range).repeat(count) + " 0 0 0 0 0 0 1 h 1";
    }

    static byte[] gzip(String text) throws IOException {
        var bytes = new ByteArrayOutputStream();
        try (var packed = new GZIPOutputStream(bytes)) {
            packed.write(text.getBytes(StandardCharsets.UTF_8));
        }
        return bytes.toByteArray();
    }
}
