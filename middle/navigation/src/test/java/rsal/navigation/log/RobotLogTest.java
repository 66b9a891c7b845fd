package rsal.navigation.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.Arrays;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Pose2d;
import rsal.navigation.carmen.CarmenFormat;
import rsal.navigation.log.LogEntry.Poses;
import rsal.testkit.PublicData;

class RobotLogTest {
    @ParameterizedTest
    @CsvSource({
        "acapulco-corrected, 861, 181",
        "aces-corrected, 440, 180",
        "edmonton-corrected, 340, 180",
        "fhw-corrected, 488, 180",
        "freiburg-101-corrected, 292, 360",
        "orebro-corrected, 237, 181",
        "seattle-corrected, 241, 361"
    })
    void readsAllScansOfPublicLogs(String name, int scans, int beams) throws IOException {
        RobotLog log = LogFormats.read(PublicData.file("logs/%s.log.gz".formatted(name)), LaserHints.DEFAULT);

        assertThat(log.scans()).hasSize(scans).allMatch(scan -> scan.scan().count() == beams);
        assertThat(log.scans()).isSortedAccordingTo((a, b) -> a.time().compareTo(b.time()));
        assertThat(log.skipped().counts().keySet()).isSubsetOf("back in time");
        assertThat(log.wandering()).isEmpty();
        assertThat(log.degrees()).isEmpty();
        assertThat(log.oneTime().isPresent()).as("all at 0 s").isEqualTo(name.equals("orebro-corrected"));
    }

    @Test
    void headingsThatGoInLargeStepsBeyondTwoTurnsAreDegrees() throws IOException {
        assertThat(turning(i -> 8.6 * i).degrees()).hasValue(8.6 * 40);
        assertThat(turning(i -> 8.6 * i % 360 - 180).degrees()).isPresent();
        assertThat(turning(i -> 6.0 * i).degrees()).as("steps of about 2π").isPresent();
        assertThat(turning(i -> i % 4 == 0 ? 90.0 : 0.0).degrees())
                .as("corners")
                .isPresent();
    }

    @Test
    void headingsAreRadiansWhetherTheyAreWrappedOrNot() throws IOException {
        assertThat(turning(i -> 0.4 * i).degrees()).as("turns on and on").isEmpty();
        assertThat(turning(i -> Math.IEEEremainder(2.5 * i, 2 * Math.PI)).degrees())
                .as("wrapped")
                .isEmpty();
        assertThat(turning(i -> i == 20 ? 100.0 : 0.4 * i).degrees())
                .as("a slip")
                .isEmpty();
        assertThat(turning(i -> i == 20 ? 100.0 : Math.IEEEremainder(0.9 * i, 2 * Math.PI))
                        .degrees())
                .as("a slip between wrapped ones")
                .isEmpty();
    }

    private static RobotLog turning(IntToDoubleFunction heading) throws IOException {
        return read(IntStream.rangeClosed(0, 40)
                .mapToObj(i -> {
                    double theta = heading.applyAsDouble(i);
                    return "FLASER 3 1 2 3 0 0 %1$s 0 0 %1$s %2$d h 0\n".formatted(theta, i + 1);
                })
                .collect(Collectors.joining()));
    }

    @Test
    void oneTimeOfAllScansSaysNothing() throws IOException {
        assertThat(taken(7, 7, 7, 7, 7).oneTime()).hasValue(Instant.ofEpochSecond(7));
        assertThat(taken(0, 0, 0, 0, 0).oneTime()).hasValue(Instant.EPOCH);
        assertThat(taken(7, 7, 7, 7, 8).oneTime()).isEmpty();
        assertThat(taken(7, 7).oneTime()).as("too few").isEmpty();
    }

    private static RobotLog taken(int... times) throws IOException {
        return read(Arrays.stream(times)
                .mapToObj("FLASER 3 1 2 3 0 0 0 0 0 0 %d h 0\n"::formatted)
                .collect(Collectors.joining()));
    }

    @Test
    void theLongestReadingOfALogStandsForNothingWhenItIsThatOften() throws IOException {
        RobotLog log = read(IntStream.range(0, 50)
                .mapToObj(i -> "FLASER 6 1 2 %s 8 8 8 0 0 0 0 0 0 %d h 0\n".formatted(3 + i * 0.09, i + 1))
                .collect(Collectors.joining()));

        assertThat(log.rangeMax()).isCloseTo(7.9, within(1e-6));
        assertThat(log.scans().getLast().scan().ranges()[5]).isEqualTo(Float.POSITIVE_INFINITY);
        assertThat(log.scans().getLast().scan().ranges()[2]).isCloseTo(7.41f, within(1e-6f));
    }

    @Test
    void theLongestReadingsOfALogAreRangesWhenTheyAreFew() throws IOException {
        RobotLog log = read(IntStream.range(0, 50)
                .mapToObj(i -> "FLASER 4 1 2 3 %s 0 0 0 0 0 0 %d h 0\n".formatted(3 + i * 0.09, i + 1))
                .collect(Collectors.joining()));

        assertThat(log.rangeMax()).isEqualTo(50);
        assertThat(log.scans().getLast().scan().ranges()[3]).isCloseTo(7.41f, within(1e-6f));
    }

    @Test
    void theFarCornerOfARoomWhereARobotStandsIsThere() throws IOException {
        RobotLog log = read(IntStream.range(0, 200)
                .mapToObj(i -> "FLASER 7 1 5.5 5.7 5.9 5.72 5.53 2 0 0 0 0 0 0 %d h 0\n".formatted(i + 1))
                .collect(Collectors.joining()));

        assertThat(log.rangeMax()).isEqualTo(50);
        assertThat(log.scans().getLast().scan().ranges()[3]).isCloseTo(5.9f, within(1e-6f));
    }

    @Test
    void aLaserThatMovesAboutOnItsRobotIsInItsMiddleAndItsPosesAreCorrectedOnes() throws IOException {
        RobotLog log = read(robotLaser(i -> new Pose2d(0.1 * i, 0.02 * i, 0.01 * i)));

        assertThat(log.wandering()).hasValueSatisfying(by -> {
            assertThat(by.meters()).isCloseTo(0.566, within(0.01));
            assertThat(by.radians()).isCloseTo(0.2, within(0.01));
        });
        assertThat(log.scans())
                .allMatch(scan -> scan.scan().baseFromLaser().equals(Pose2d.ORIGIN))
                .allMatch(scan -> scan.poses() instanceof Poses.Reported);
        var reported = (Poses.Reported) log.scans().get(10).poses();
        assertThat(reported.mapFromBase().isNear(new Pose2d(1, 0.2, 0.1), 1e-5, 1e-5))
                .isTrue();
        assertThat(reported.odomFromBase().isNear(new Pose2d(0.8, 0, 0), 1e-5, 1e-5))
                .isTrue();
    }

    @Test
    void aLaserMayBeMountedAnywhereAndAFewPosesBeAtOdds() throws IOException {
        RobotLog log = read(robotLaser(i -> new Pose2d(0.08 * i + (i == 7 ? 0.4 : 0.2), -0.1, 3)));

        assertThat(log.wandering()).isEmpty();
        assertThat(log.scans().get(10).scan().baseFromLaser().isNear(new Pose2d(0.2, -0.1, 3), 1e-5, 1e-5))
                .isTrue();
    }

    /// A robot that drives ahead by 8 cm each time.
    private static String robotLaser(IntFunction<Pose2d> odomFromLaser) {
        return IntStream.range(0, 40)
                .mapToObj(i -> {
                    Pose2d laser = odomFromLaser.apply(i);
                    return "ROBOTLASER1 0 -1 2 1 20 0.01 0 3 1 2 3 0 %.6f %.6f %.6f %.6f 0 0 0 0 0.3 0.3 0.5 %d h 0%n"
                            .formatted(laser.x(), laser.y(), laser.theta(), 0.08 * i, i + 1);
                })
                .collect(Collectors.joining());
    }

    private static RobotLog read(String text) throws IOException {
        return LogFormats.read(
                new CarmenFormat(),
                "test.log",
                new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
                LaserHints.DEFAULT);
    }
}
