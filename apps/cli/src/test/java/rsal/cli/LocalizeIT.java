package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal localize` as a process of its own, on the log of a robot that drives through a room and back.
class LocalizeIT {
    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
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
        JsonNode reported = new JsonMapper().readTree(ended.out());
        assertThat(reported.path("summary").path("converged10").asDouble()).isEqualTo(1);
        assertThat(reported.path("summary").path("rmse").asDouble()).isLessThan(0.08);
        assertThat(reported.path("runs").size()).isEqualTo(3);
        JsonNode step = reported.path("runs").path(0).path("steps").path(5);
        assertThat(step.path("covariance").size()).isEqualTo(6);
        assertThat(step.path("confidence").asDouble()).isBetween(0.0, 1.0);
        assertThat(step.path("quality").asString()).isEqualTo("localized");
        assertThat(step.path("particles").asInt()).isPositive();

        Ended again = rsal.run("localize", "room.log", "--map", "room.yaml", "--pose", "1.3", "3.2", "5");
        assertThat(again.code()).as(again.err()).isEqualTo(Exit.SUCCESS);
        assertThat(again.out())
                .contains("localized", "converged after 1 scan;")
                .doesNotContain("lost at 1", "of these scans");
    }

    @Test
    void saysBesideItsErrorsThatItWasLostAfterwardsAndWhatThatMayComeFrom() throws Exception {
        assertThat(rsal.run("localize", "room.log", "--map-from-half", "--scans", "2", "--save-map", "room.yaml")
                        .code())
                .isEqualTo(Exit.SUCCESS);
        String[] lines = RoomLog.whole().split("\n");
        for (int i = 7; i < lines.length; i++) { // from here on they fit nowhere
            String[] words = lines[i].split(" ");
            for (int reading = 2; reading < 183; reading++) {
                words[reading] = reading % 2 == 0 ? "0.4" : "1.9";
            }
            lines[i] = String.join(" ", words);
        }
        Files.writeString(folder.resolve("misfit.log"), String.join("\n", lines) + "\n");

        Ended ended = rsal.run("localize", "misfit.log", "--map", "room.yaml", "--pose", "1.3", "3.2", "5");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out()).containsPattern("from there on rmse \\S+ m \\(lost at \\d+% of these scans\\), 95%");
        assertThat(ended.err()).contains("its ranges are in other units than meters");
    }

    @Test
    void aReferenceSaysWhereScansOfARawLogWereTaken() throws Exception {
        Files.writeString(
                folder.resolve("raw.log"),
                RoomLog.whole().replaceAll("(?m) \\S+ \\S+ \\S+ (\\S+ h \\S+)$", " 0 0 0 $1"));

        Ended ended = rsal.run("localize", "raw.log", "--reference", "room.log", "--map-from-half", "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode reported = new JsonMapper().readTree(ended.out());
        assertThat(reported.path("runs").path(0).path("judged").asInt()).isPositive();
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
    void reportsWhatItSkipped() throws Exception {
        Files.writeString(folder.resolve("bad.log"), "FLASER 3 1 2\n" + RoomLog.whole());

        Ended ended = rsal.run("localize", "bad.log", "--map-from-half", "--scans", "2");

        assertThat(ended.code()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.err()).contains("1 of 42 scans (1 cut short)", "bad.log:1:");
    }

    @Test
    void saysThatNoneOfManyRunsConverged() throws Exception {
        Ended ended = rsal.run(
                "localize", "room.log", "--map", "office", "--pose", "3", "3", "0", "--seeds", "2", "--scans", "8");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out()).contains("seed 2: never converged", "2 runs: 0% converged", "0% at all", "rmse - m");
    }

    @Test
    void aSavedMapIsNotOverwrittenUnasked() throws Exception {
        String[] line = {"localize", "room.log", "--map-from-half", "--scans", "2", "--save-map", "mine.yaml"};
        Files.writeString(folder.resolve("mine.pgm"), "dear to me");

        Ended refused = rsal.run(line);
        assertThat(refused.code()).isEqualTo(Exit.INVALID);
        assertThat(refused.err()).contains("mine.pgm", "--force");
        assertThat(folder.resolve("mine.pgm")).hasContent("dear to me");
        assertThat(folder.resolve("mine.yaml")).doesNotExist();

        var forced = new java.util.ArrayList<>(java.util.List.of(line));
        forced.add("--force");
        assertThat(rsal.run(forced.toArray(String[]::new)).code()).isEqualTo(Exit.SUCCESS);
        assertThat(folder.resolve("mine.yaml")).isNotEmptyFile();
    }

    /// As of one whose cells were taken for meters, not centimeters. It was searched for hours.
    @Test
    @LongTest
    void aMapThatIsTooLargeToBeSearchedIsRefusedUnlessAPoseIsGiven() throws Exception {
        Files.writeString(
                folder.resolve("large.pgm"), "P2 50 50 255\n" + "254 ".repeat(49) + "0 " + "254 ".repeat(2450));
        Files.writeString(folder.resolve("large.yaml"), """
                image: large.pgm
                resolution: 100
                origin: [0, 0, 0]
                negate: 0
                occupied_thresh: 0.65
                free_thresh: 0.196
                """);
        Ended ended = rsal.run("localize", "room.log", "--map", "large.yaml");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.INVALID);
        assertThat(ended.err()).contains("large.yaml", "24990000 m²", "90000 m²", "--pose", "100.0 m");
        String[] reported = {"localize", "room.log", "--map", "large.yaml", "--pose", "50", "50", "0", "--scans", "20"};
        assertThat(rsal.run(reported).code()).isEqualTo(Exit.SUCCESS);
    }

    @Test
    void aLogThatHasNoReturnsSaysNothing() throws Exception {
        String nothing = RoomLog.whole().replaceAll("FLASER 181( \\S+){181}", "FLASER 181" + " 81.91".repeat(181));
        Files.writeString(folder.resolve("void.log"), nothing);

        Ended localize = rsal.run("localize", "void.log", "--map", "office", "--pose", "0", "0", "0");
        assertThat(localize.code()).isEqualTo(Exit.INVALID);
        assertThat(localize.err()).contains("void.log", "No beam of any of its 41 scans hit anything");
        assertThat(rsal.run("map", "void.log", "--out", "void").code()).isEqualTo(Exit.INVALID);
        assertThat(folder.resolve("void")).doesNotExist();
    }

    @Test
    void manyScansThatCannotBeUsedAreNotMissed() throws Exception {
        var lines = new java.util.ArrayList<>(RoomLog.whole().lines().toList());
        for (int i = 4; i < 10; i++) {
            lines.set(i, "FLASER 3 1 2");
        }
        Files.write(folder.resolve("holes.log"), lines);
        Ended warned = rsal.run("localize", "holes.log", "--map-from-half", "--scans", "2");
        assertThat(warned.code()).as(warned.err()).isEqualTo(Exit.SUCCESS);
        assertThat(warned.err())
                .contains("WARNING", "6 of 41 scans (6 cut short)")
                .doesNotContain("{");

        for (int i = 4; i < 30; i++) {
            lines.set(i, "FLASER 3 1 2");
        }
        Files.write(folder.resolve("holes.log"), lines);
        Ended refused = rsal.run("localize", "holes.log", "--map-from-half");
        assertThat(refused.code()).isEqualTo(Exit.INVALID);
        assertThat(refused.err()).contains("Most of its scans can't be used", "26 of 41 scans", "line 5");
    }

    @Test
    void odometryThatIsSkippedIsNoScan() throws Exception {
        Files.writeString(folder.resolve("odom.log"), "ODOM 1 2\n" + RoomLog.whole());
        Ended ended = rsal.run("localize", "odom.log", "--map-from-half", "--scans", "2");
        assertThat(ended.err()).contains("no scan, 1 other messages").doesNotContain("WARNING");
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            localize room.log                                            | --map                 | 2
            localize room.log --map a.yaml --map-from-half               | exclusive             | 2
            localize room.log --map-from-half --odometry-noise 1         | '1'                   | 2
            localize room.log --map-from-half --odometry-noise 1,-2,3    | '1,-2,3'              | 2
            localize room.log --map-from-half --odometry-noise Infinity,1,1 | 'Infinity,1,1'     | 2
            localize room.log --map-from-half --pose NaN 0 0             | NaN                   | 2
            localize room.log --map-from-half --seeds 0                  | --seeds               | 2
            localize room.log --map-from-half --seeds abc                | 'abc' is not a whole  | 2
            localize room.log --map-from-half --beams 0                  | --beams must be at least 5, not '0' | 2
            localize room.log --map-from-half --min-particles 6000       | --min-particles (6000) | 2
            localize room.log --map-from-half --max-range -1             | --max-range must be   | 2
            localize room.log --map-from-half --max-range far            | 'far' is not a number | 2
            localize room.log --map-from-half --field-of-view 400        | not '400.0'           | 2
            localize room.log --map-from-half --model beam5              | Maybe 'beam'          | 2
            localize room.log --map office --save-map x.yaml             | no other map          | 2
            localize room.log --map-from-half --save-map x.png           | must end with .yaml   | 2
            localize room.log --map-from-half --save-map nix/x.yaml      | There is no such folder | 3
            localize room.log --map-from-half --pose 4000 1 0            | far off the map       | 3
            localize none.log --map-from-half                            | none.log              | 3
            localize room.log --map none.yaml                            | none.yaml             | 3
            localize room.log --map-from-half --reference none.log       | none.log              | 3
            localize room.log --map-from-half --no-reference             | no poses for its scans | 3
            """)
    void refusesWhatItCannotDo(String line, String expected, int code) throws Exception {
        Ended ended = rsal.run(line.split(" "));
        assertThat(ended.code()).as(ended.err()).isEqualTo(code);
        assertThat(ended.err()).contains(expected).doesNotContain("\tat ");
        assertThat(ended.out()).isEmpty();
    }
}
