package rsal.navigation.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.carmen.CarmenFormat;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.RobotLog;

class RecordedDriveTest {
    private static final String RAW = """
            RAWLASER1 0 -1 2 1 20 0.01 0 3 1 2 3 0 0.5 h 0
            ODOM 1 0 0 0 0 0 1 h 0
            RAWLASER1 0 -1 2 1 20 0.01 0 3 1 2 4 0 1.25 h 0
            ODOM 2 0 1 0 0 0 2 h 0
            RAWLASER1 0 -1 2 1 20 0.01 0 3 1 2 5 0 3 h 0
            """;

    @Test
    void aScanWithoutOdometryHasThatAroundIt() throws IOException {
        RecordedDrive drive = RecordedDrive.of(log(RAW));

        assertThat(drive.omitted()).isEqualTo(1);
        assertThat(drive.stops()).hasSize(2);
        Pose2d between = drive.stops().getFirst().odomFromBase();
        assertThat(between.x()).isCloseTo(1.25, within(1e-9));
        assertThat(between.theta()).isCloseTo(0.25, within(1e-9));
        assertThat(drive.stops().getLast().odomFromBase()).isEqualTo(new Pose2d(2, 0, 1));
        assertThat(drive.posed()).isEmpty();
    }

    @Test
    void odometryThatEndsEarlyIsNotThatOfLaterScans() throws IOException {
        RecordedDrive drive = RecordedDrive.of(log(RAW + "RAWLASER1 0 -1 2 1 20 0.01 0 3 1 2 6 0 3.5 h 0\n"));

        assertThat(drive.stops()).hasSize(2);
        assertThat(drive.omitted()).isEqualTo(2);
    }

    @Test
    void anotherLogOfTheSameScansSaysWhereTheyWereTaken() throws IOException {
        RecordedDrive drive = RecordedDrive.of(log("""
                FLASER 3 1 2 3 0 0 0 5 5 0 1 h 1
                FLASER 3 1 2 4 0 0 0 6 5 0 2 h 2
                """)).judgedBy(log("FLASER 3 1 2 4 7 7 1 7 7 1 9 h 9\n"));

        assertThat(drive.stops().get(0).mapFromBase()).isEmpty();
        assertThat(drive.stops().get(1).mapFromBase()).isEqualTo(Optional.of(new Pose2d(7, 7, 1)));
        assertThat(drive.stops().get(1).odomFromBase()).isEqualTo(new Pose2d(6, 5, 0));
    }

    @Test
    void stepsThatNoRobotMakesAreTakenOutOfTheOdometry() throws IOException {
        RecordedDrive drive = RecordedDrive.of(log("""
                FLASER 3 1 2 3 0 0 0 1 0 0 1 h 1
                FLASER 3 1 2 4 0 0 0 1.2 0 0 1.2 h 1.2
                FLASER 3 1 2 5 0 0 0 9 9 1.5 1.4 h 1.4
                FLASER 3 1 2 6 0 0 0 9 9.2 1.5 1.6 h 1.6
                FLASER 3 1 2 7 0 0 0 9 19.2 1.5 21.6 h 21.6
                """));

        assertThat(drive.leaps()).singleElement().satisfies(leap -> {
            assertThat(leap.line()).isEqualTo(3);
            assertThat(leap.meters()).isCloseTo(Math.hypot(7.8, 9), within(1e-9));
            assertThat(leap.radians()).isCloseTo(1.5, within(1e-9));
            assertThat(leap.seconds()).isCloseTo(0.2, within(1e-9));
        });
        RecordedDrive mended = drive.withoutLeaps();
        assertThat(mended.leaps()).isEmpty();
        assertThat(step(mended, 2).isNear(Pose2d.ORIGIN, 1e-9, 1e-9)).isTrue();
        for (int i : new int[] {1, 3, 4}) {
            Pose2d reported = step(drive, i);
            assertThat(step(mended, i).isNear(reported, 1e-9, 1e-9))
                    .as("step %d", i)
                    .isTrue();
        }
    }

    private static Pose2d step(RecordedDrive drive, int i) {
        return drive.stops()
                .get(i - 1)
                .odomFromBase()
                .inverse()
                .compose(drive.stops().get(i).odomFromBase());
    }

    @Test
    void logsWithoutTimesHaveNoLeaps() throws IOException {
        RecordedDrive drive = RecordedDrive.of(log("""
                FLASER 3 1 2 3 0 0 0 1 0 0 1 h 1
                FLASER 3 1 2 4 0 0 0 9 9 0 1 h 1
                """));

        assertThat(drive.leaps()).isEmpty();
        assertThat(drive.withoutLeaps().stops()).isEqualTo(drive.stops());
    }

    @Test
    void scansThatLookTheSameAtSeveralPlacesShowNoPlace() throws IOException {
        RecordedDrive drive = RecordedDrive.of(log("""
                FLASER 3 1 2 3 0 0 0 0 0 0 1 h 1
                FLASER 3 inf inf inf 1 0 0 1 0 0 2 h 2
                FLASER 3 9 9 9 2 0 0 2 0 0 3 h 3
                FLASER 3 inf inf inf 8 0 0 8 0 0 4 h 4
                FLASER 3 9 9 9 9 0 0 9 0 0 5 h 5
                FLASER 3 4 4 4 9 0 0 9 0 0 6 h 6
                FLASER 3 4 4 4 9 0 0 9 0 0 7 h 7
                """)).judgedBy(log("""
                FLASER 3 1 2 3 7 7 1 7 7 1 1 h 9
                FLASER 3 inf inf inf 8 7 1 8 7 1 2 h 9
                FLASER 3 inf inf inf 15 7 1 15 7 1 4 h 9
                FLASER 3 9 9 9 16 7 1 16 7 1 5 h 9
                FLASER 3 4 4 4 16 7 1 16 7 1 6 h 9
                FLASER 3 4 4 4 16.01 7 1 16.01 7 1 7 h 9
                """));

        assertThat(drive.stops().stream().map(RecordedDrive.Stop::mapFromBase).toList())
                .containsExactly(
                        Optional.of(new Pose2d(7, 7, 1)),
                        Optional.empty(), // the reference has two of them
                        Optional.empty(), // the reference has one of two
                        Optional.empty(),
                        Optional.empty(),
                        Optional.of(new Pose2d(16, 7, 1)), // it stood there
                        Optional.of(new Pose2d(16, 7, 1)));
    }

    @Test
    void wheelsThatErrDriftAwayAndTheTruthStays() throws IOException {
        var lines = new StringBuilder();
        for (int i = 0; i < 200; i++) {
            lines.append("FLASER 1 1 %d 0 0 %d 0 0 %d h 0\n".formatted(i, i, i + 1));
        }
        RecordedDrive drive = RecordedDrive.of(log(lines.toString()));
        var noise = new OdometryModel(0.05, 0.03, 0.05);

        RecordedDrive drifted = drive.drifting(noise, new SplittableRandom(1));

        assertThat(drifted.stops().getLast().mapFromBase())
                .isEqualTo(drive.stops().getLast().mapFromBase());
        assertThat(drifted.stops().getLast().odomFromBase().distanceTo(new Pose2d(199, 0, 0)))
                .isBetween(1.0, 199.0);
        assertThat(drive.drifting(noise, new SplittableRandom(1))).isEqualTo(drifted);
        assertThat(drive.drifting(new OdometryModel(0, 0, 0), new SplittableRandom(1))
                        .stops()
                        .getLast()
                        .odomFromBase()
                        .distanceTo(new Pose2d(199, 0, 0)))
                .isLessThan(1e-9);
    }

    private static RobotLog log(String text) throws IOException {
        return LogFormats.read(
                new CarmenFormat(),
                "test.log",
                new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
                LaserHints.DEFAULT);
    }
}
