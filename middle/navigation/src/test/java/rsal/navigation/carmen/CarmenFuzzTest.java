package rsal.navigation.carmen;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogEntry;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Parameter;
import rsal.navigation.log.LogEntry.Poses;
import rsal.navigation.log.LogEntry.Scan;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.RobotLog;
import rsal.navigation.log.Skipped;
import rsal.testkit.Rounds;

/// Damages logs in all ways that come to mind: what comes out is sound, or a [BrokenLog] that says where.
class CarmenFuzzTest {
    private static final String[] NASTY = {
        "nan",
        "-nan",
        "inf",
        "-inf",
        "0",
        "-0",
        "-1",
        "1e308",
        "1e-320",
        "99999999999",
        "x",
        "",
        "FLASER",
        "\n",
        "é",
        "1,5"
    };

    private static final String SOUND = """
            # a comment
            PARAM robot_frontlaser_offset 0.1 nohost 0
            ODOM 0 0 0 0.1 0 0 1 h 1
            FLASER 5 1 2 3 4 81.91 0 0 0 0 0 0 2 h 2
            RAWLASER1 0 -1 2 0.5 20 0.01 0 5 1 2 3 4 5 0 3 h 3
            ROBOTLASER1 0 -1 2 0.5 20 0.01 0 5 1 2 3 25 4 2 7 8 1.2 1 0 1 1 0 0 0 0 0 0 4 h 4
            ODOM 1 0 0 0.1 0 0 5 h 5
            FLASER 5 1 2 3 4 5 1 0 0 1 0 0 6 h 6
            """;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void whatComesOutOfADamagedLogIsSound(long seed) throws IOException {
        var random = new SplittableRandom(seed);
        for (int i = 0; i < Rounds.of(400, 2000); i++) {
            read(damagedWords(random).getBytes(StandardCharsets.UTF_8));
            read(damagedBytes(SOUND.getBytes(StandardCharsets.UTF_8), random));
            read(damagedBytes(CarmenReaderTest.gzip(SOUND), random));
        }
    }

    private static void read(byte[] bytes) throws IOException {
        try {
            RobotLog log = LogFormats.read(
                    new CarmenFormat(), "fuzz.log", new ByteArrayInputStream(bytes), LaserHints.DEFAULT);
            log.parameters().forEach(CarmenFuzzTest::check);
            log.motions().forEach(CarmenFuzzTest::check);
            log.scans().forEach(CarmenFuzzTest::check);
            Skipped skipped = log.skipped();
            assertThat(skipped.first()).hasSize(Math.min(Skipped.TOLD, skipped.total()));
        } catch (BrokenLog e) {
            assertThat(e.getMessage()).startsWith("fuzz.log");
        }
    }

    private static void check(LogEntry entry) {
        assertThat(entry.line()).isPositive();
        switch (entry) {
            case Motion motion -> assertThat(motion.odomFromBase().isFinite()).isTrue();
            case Parameter parameter -> assertThat(parameter.name()).isNotEmpty();
            case Scan scan -> check(scan);
        }
    }

    private static void check(Scan entry) {
        var scan = entry.scan();
        assertThat(scan.baseFromLaser().isFinite()).isTrue();
        assertThat(scan.angle(scan.count() - 1)).isFinite();
        assertThat(entry.broken()).isLessThan(scan.count());
        for (int i = 0; i < scan.count(); i++) {
            float range = scan.ranges()[i];
            assertThat(range > 0 || Float.isNaN(range) || range == Float.NEGATIVE_INFINITY)
                    .isTrue();
            assertThat(range < scan.rangeMax()).isEqualTo(scan.isHit(i) || range == Float.NEGATIVE_INFINITY);
        }
        if (entry.poses() instanceof Poses.Reported reported) {
            assertThat(reported.mapFromBase().isFinite()).isTrue();
            assertThat(reported.odomFromBase().isFinite()).isTrue();
        }
    }

    private static String damagedWords(SplittableRandom random) {
        String[] words = SOUND.split("(?<=[ \n])");
        int damages = 1 + random.nextInt(4);
        for (int i = 0; i < damages; i++) {
            int at = random.nextInt(words.length);
            words[at] = switch (random.nextInt(4)) {
                case 0 -> "";
                case 1 -> words[at] + words[at];
                case 2 -> words[random.nextInt(words.length)];
                default -> NASTY[random.nextInt(NASTY.length)] + " ";
            };
        }
        return String.join("", words);
    }

    private static byte[] damagedBytes(byte[] sound, SplittableRandom random) {
        byte[] bytes = Arrays.copyOf(sound, random.nextInt(4) == 0 ? random.nextInt(sound.length) : sound.length);
        for (int i = random.nextInt(5); i > 0 && bytes.length > 0; i--) {
            bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
        }
        return bytes;
    }
}
