package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal localize` as a process of its own, on the log of a robot that drives through a room and back.
class LocalizeIT {
    @TempDir
    Path folder;

    private Rsal rsal;

    @BeforeEach
    void writeLog() throws IOException {
        rsal = new Rsal(folder);
        Files.writeString(folder.resolve("room.log"), RoomLog.whole());
    }

    @Test
    void saysWhereTheRobotWasAndHowRightThatIs() throws Exception {
        Ended ended = rsal.run(
                "localize",
                "room.log",
                "--map-from-half",
                "--save-map",
                "room.yaml",
                "--odometry-noise",
                "0.05,2,3",
                "--seeds",
                "3",
                "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode told = new JsonMapper().readTree(ended.out());
        assertThat(told.path("summary").path("converged10").asDouble()).isEqualTo(1);
        assertThat(told.path("summary").path("rmse").asDouble()).isLessThan(0.08);
        assertThat(told.path("runs").size()).isEqualTo(3);
        JsonNode step = told.path("runs").path(0).path("steps").path(5);
        assertThat(step.path("covariance").size()).isEqualTo(6);
        assertThat(step.path("confidence").asDouble()).isBetween(0.0, 1.0);
        assertThat(step.path("quality").asString()).isEqualTo("localized");
        assertThat(step.path("particles").asInt()).isPositive();

        Ended again = rsal.run("localize", "room.log", "--map", "room.yaml", "--pose", "1.3", "3.2", "5");
        assertThat(again.code()).as(again.err()).isEqualTo(Exit.SUCCESS);
        assertThat(again.out()).contains("localized", "converged after 1 scans");
    }

    @Test
    void aReferenceTellsWhereScansOfARawLogWereTaken() throws Exception {
        Files.writeString(
                folder.resolve("raw.log"),
                RoomLog.whole().replaceAll("(?m) \\S+ \\S+ \\S+ (\\S+ h \\S+)$", " 0 0 0 $1"));

        Ended ended = rsal.run("localize", "raw.log", "--reference", "room.log", "--map-from-half", "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode told = new JsonMapper().readTree(ended.out());
        assertThat(told.path("runs").path(0).path("judged").asInt()).isPositive();
    }

    @Test
    void aPackedLogIsReadAndOneCutShortRefused() throws Exception {
        try (var packed = new GZIPOutputStream(Files.newOutputStream(folder.resolve("room.log.gz")))) {
            packed.write(Files.readAllBytes(folder.resolve("room.log")));
        }
        byte[] bytes = Files.readAllBytes(folder.resolve("room.log.gz"));
        Files.write(folder.resolve("cut.log.gz"), java.util.Arrays.copyOf(bytes, bytes.length / 2));

        assertThat(rsal.run("localize", "room.log.gz", "--map-from-half", "--scans", "3")
                        .code())
                .isEqualTo(Exit.SUCCESS);
        Ended cut = rsal.run("localize", "cut.log.gz", "--map-from-half");
        assertThat(cut.code()).isEqualTo(Exit.INVALID);
        assertThat(cut.err()).contains("cut.log.gz:", "ends early");
        assertThat(cut.out()).isEmpty();
    }

    @Test
    void tellsWhatItSkipped() throws Exception {
        Files.writeString(folder.resolve("bad.log"), "FLASER 3 1 2\n" + RoomLog.whole());

        Ended ended = rsal.run("localize", "bad.log", "--map-from-half", "--scans", "2");

        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.err()).contains("cut short=1", "bad.log:1:");
    }

    @Test
    void saysThatNoneOfManyRunsConverged() throws Exception {
        Ended ended = rsal.run(
                "localize", "room.log", "--map", "office", "--pose", "3", "3", "0", "--seeds", "2", "--scans", "8");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out()).contains("seed 2: never converged", "2 runs: 0% converged", "0% at all", "rmse - m");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            localize room.log                                            | --map                 | 2
            localize room.log --map a.yaml --map-from-half               | exclusive             | 2
            localize room.log --map-from-half --odometry-noise 1         | (1)                   | 2
            localize room.log --map-from-half --odometry-noise 1,-2,3    | (1,-2,3)              | 2
            localize room.log --map-from-half --odometry-noise Infinity,1,1 | (Infinity,1,1)     | 2
            localize room.log --map-from-half --pose NaN 0 0             | NaN                   | 2
            localize room.log --map-from-half --seeds 0                  | --seeds               | 2
            localize none.log --map-from-half                            | none.log              | 3
            localize room.log --map none.yaml                            | none.yaml             | 3
            localize room.log --map-from-half --reference none.log       | none.log              | 3
            localize room.log --map-from-half --no-reference             | Nothing tells         | 3
            """)
    void refusesWhatItCannotDo(String line, String expected, int code) throws Exception {
        Ended ended = rsal.run(line.split(" "));
        assertThat(ended.code()).as(ended.err()).isEqualTo(code);
        assertThat(ended.err()).contains(expected).doesNotContain("\tat ");
        assertThat(ended.out()).isEmpty();
    }
}
