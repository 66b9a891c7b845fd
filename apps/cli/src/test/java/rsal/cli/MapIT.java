package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.cli.terminal.Exit;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal map` as a process of its own, on the log of a robot that drives through a room and back.
class MapIT {
    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    Path folder;

    private Rsal rsal;

    @BeforeEach
    void writeLog() throws IOException {
        rsal = new Rsal(folder);
        Files.writeString(folder.resolve("room.log"), RoomLog.whole());
    }

    @Test
    void mapsARoomThoughTheWheelsErr() throws Exception {
        Ended ended = rsal.run("map", "room.log", "--odometry-noise", "0.05,2,3", "--out", "room", "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode reported = new JsonMapper().readTree(ended.out());
        JsonNode log = reported.path("logs").path(0);
        assertThat(log.path("scans").asInt()).isEqualTo(41);
        assertThat(log.path("next").path("meters").asDouble()).isLessThan(0.02);
        assertThat(log.path("next").path("degrees").asDouble()).isLessThan(0.5);
        assertThat(log.path("odometry").path("degrees").asDouble()).isGreaterThan(0.5);
        JsonNode residual = reported.path("residual");
        assertThat(residual.path("tooLarge").asBoolean(true)).isFalse();
        assertThat(residual.path("wheels").path("deviations").asDouble()).isPositive();
        assertThat(residual.path("steps").asInt()).isEqualTo(log.path("kept").asInt() - 1);
        assertThat(ended.err()).doesNotContain("probably wrong");
        OccupancyGrid map =
                new Maps(FileSource.disk()).read(folder.resolve("room/map.yaml").toString(), Location.of("test"));
        Pose2d start = RoomLog.START;
        assertThat(map.isFree(start.x(), start.y())).isTrue();
        assertThat(Files.readAllLines(folder.resolve("room/trajectory.txt"))).hasSize(42);
        List<String> residuals = Files.readAllLines(folder.resolve("room/residuals.csv"));
        assertThat(residuals.getFirst()).startsWith("from,to,source,");
        assertThat(residuals).anyMatch(line -> line.contains(",scans,"));
        assertThat(folder.resolve("room/picture.png")).isNotEmptyFile();
    }

    @Test
    void warnsWhenTheMapDiffersFromAllMeasurementsOfTheWay() throws Exception {
        Pose2d carried = new Pose2d(0, 1, 0); // as the wheels tell it, by more than scans are searched for
        Files.writeString(
                folder.resolve("carried.log"), RoomLog.part(0, 22, Pose2d.ORIGIN) + RoomLog.part(23, 40, carried));

        Ended ended = rsal.run("map", "carried.log", "--no-reference", "--out", "carried");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.err()).contains("The map is probably wrong: at (", "from keyframe 11 to 12", "Maybe");
        assertThat(ended.out()).contains("wheels, at most", "scans, at most", "no scan confirms 1 of 20 steps");
        Ended json = rsal.run("map", "carried.log", "--no-reference", "--out", "again", "--json");
        JsonNode residual = new JsonMapper().readTree(json.out()).path("residual");
        assertThat(residual.path("tooLarge").asBoolean()).isTrue();
        assertThat(residual.path("all").path("from").asInt()).isEqualTo(11);
        assertThat(residual.path("blind").asInt()).isEqualTo(1);
        assertThat(json.err()).contains("probably wrong");
    }

    @Test
    @LongTest
    void warnsOfALaserThatIsUpsideDownAndReadsItRightWhenItIsAskedTo() throws Exception {
        Files.writeString(folder.resolve("mirrored.log"), RoomLog.mirrored());

        Ended ended = rsal.run("map", "mirrored.log", "--out", "mirrored", "--json");

        assertThat(ended.err()).contains("probably mirrored: at", "--upside-down");
        JsonNode turns =
                new JsonMapper().readTree(ended.out()).path("logs").path(0).path("turns");
        assertThat(turns.path("reversed").asBoolean()).isTrue();
        assertThat(turns.path("count").asInt()).isGreaterThanOrEqualTo(8);
        assertThat(turns.path("opposed").asInt())
                .isGreaterThan(turns.path("count").asInt() * 3 / 4);
        Ended right = rsal.run("map", "mirrored.log", "--out", "right", "--upside-down", "--json");
        JsonNode reported = new JsonMapper().readTree(right.out());
        assertThat(right.err()).doesNotContain("probably");
        assertThat(reported.path("logs").path(0).path("turns").path("opposed").asInt(-1))
                .isZero();
        assertThat(reported.path("contradiction").path("tooLarge").asBoolean(true))
                .isFalse();
    }

    @Test
    void reportsThatALogHasItsLaserMoveAboutOnTheRobot() throws Exception {
        Files.writeString(
                folder.resolve("raw.log"), RoomLog.part(0, 20, Pose2d.ORIGIN) + RoomLog.corrected(21, 40, 0.3));

        Ended ended = rsal.run("map", "raw.log", "--out", "raw", "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.err()).contains("In 'raw.log', the laser moves on the robot", "(0.30 m)");
        JsonNode wandering =
                new JsonMapper().readTree(ended.out()).path("logs").path(0).path("wandering");
        assertThat(wandering.path("meters").asDouble()).isBetween(0.29, 0.31);
    }

    @Test
    void writesNumbersAlikeEverywhere() throws Exception {
        Ended ended = rsal.with("-Duser.language=de", "-Duser.country=DE").run("map", "room.log", "--out", "room");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(Files.readString(folder.resolve("room/trajectory.txt"))).doesNotContain(",");
    }

    @Test
    void drawsNothingBeyondTheLongestRange() throws Exception {
        assertThat(rsal.run("map", "room.log", "--known-poses", "--out", "all").code())
                .isEqualTo(Exit.SUCCESS);
        assertThat(rsal.run("map", "room.log", "--known-poses", "--max-range", "1", "--out", "near")
                        .code())
                .isEqualTo(Exit.SUCCESS);

        assertThat(occupied("near")).isLessThan(occupied("all") / 2);
    }

    private long occupied(String of) {
        OccupancyGrid map = new Maps(FileSource.disk())
                .read(folder.resolve(of + "/map.yaml").toString(), Location.of("test"));
        return IntStream.range(0, map.cells().length)
                .filter(cell -> map.cells()[cell] == OccupancyGrid.OCCUPIED)
                .count();
    }

    @Test
    void reportsNoErrorsWhenTheLogsPosesAreNotRight() throws Exception {
        Ended ended = rsal.run("map", "room.log", "--no-reference", "--out", "raw", "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode log = new JsonMapper().readTree(ended.out()).path("logs").path(0);
        assertThat(log.path("scans").asInt()).isEqualTo(41);
        for (String error : List.of("odometry", "next", "near")) {
            assertThat(log.path(error).has("meters")).as(error).isFalse();
        }

        Ended judged = rsal.run("map", "room.log", "--no-reference", "--reference", "room.log", "--out", "judged");
        assertThat(judged.code()).as(judged.err()).isEqualTo(Exit.SUCCESS);
        assertThat(judged.out()).contains("map, scan to scan");
    }

    @Test
    void drawsFromKnownPosesAndOverwritesNothingUnasked() throws Exception {
        Ended ended = rsal.run("map", "room.log", "--known-poses", "--out", "known");
        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        assertThat(ended.out()).contains("41 scans", "map.yaml");

        Ended again = rsal.run("map", "room.log", "--known-poses", "--out", "known");
        assertThat(again.code()).isEqualTo(Exit.INVALID);
        assertThat(again.err()).contains("map.yaml", "--force");
        assertThat(rsal.run("map", "room.log", "--known-poses", "--out", "known", "--force")
                        .code())
                .isEqualTo(Exit.SUCCESS);
    }

    @Test
    void joinsTheMapsOfTwoRobotsThatBeganElsewhere() throws Exception {
        Files.writeString(folder.resolve("other.log"), RoomLog.part(10, 40, new Pose2d(30, -7, 2)));

        Ended ended = rsal.run("map", "room.log", "other.log", "--out", "both", "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode reported = new JsonMapper().readTree(ended.out());
        assertThat(reported.path("logs").size()).isEqualTo(2);
        assertThat(reported.path("merged").size()).isEqualTo(1);
        JsonNode merged = reported.path("merged").path(0);
        assertThat(merged.path("log").asString()).isEqualTo("other.log");
        assertThat(Math.hypot(merged.path("x").asDouble(), merged.path("y").asDouble()))
                .isGreaterThan(10);
        assertThat(merged.path("squareMeters").asDouble()).isGreaterThan(10);
        assertThat(merged.path("against").isNumber()).isTrue();
        assertThat(merged.path("against").asDouble()).isLessThan(0.03);
        assertThat(reported.path("columns").asInt() * 0.05).isBetween(9.0, 11.0);
        assertThat(folder.resolve("both/trajectory-2.txt")).isNotEmptyFile();
    }

    @Test
    void joinsNoMapsThatFitInTwoWaysButReportsBoth() throws Exception {
        Files.writeString(folder.resolve("one.log"), RoomLog.twoSided(0, 40, Pose2d.ORIGIN));
        Files.writeString(folder.resolve("other.log"), RoomLog.twoSided(5, 35, new Pose2d(30, -7, 2)));

        Ended ended = rsal.run("map", "one.log", "other.log", "--out", "both");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.INVALID);
        assertThat(ended.err()).contains("other.log", "in two ways", "°", "Maybe");
        assertThat(folder.resolve("both")).doesNotExist();
    }

    @Test
    void reportsWhereMapsContradictEachOtherAndJoinsThemWhenAsked() throws Exception {
        Files.writeString(folder.resolve("other.log"), RoomLog.withBox(10, 40, new Pose2d(30, -7, 2)));

        Ended refused = rsal.run("map", "room.log", "other.log", "--out", "both");

        assertThat(refused.code()).as(refused.err()).isEqualTo(Exit.INVALID);
        assertThat(refused.err())
                .contains("other.log", "that of 'room.log'", "contradict", "at most 1.5%", "0.7 m")
                .containsPattern("at \\(6\\.\\d, [12]\\.\\d\\), where 'other.log' hit what 'room.log' saw free")
                .contains("--despite-contradictions");
        assertThat(folder.resolve("both")).doesNotExist();

        Ended json = rsal.run("map", "room.log", "other.log", "--out", "json", "--json", "--despite-contradictions");
        assertThat(json.code()).as(json.err()).isEqualTo(Exit.SUCCESS);
        assertThat(json.err()).contains("probably wrong: 'other.log' contradicts", "at most 1.5%");
        JsonNode merged = new JsonMapper().readTree(json.out()).path("merged").path(0);
        assertThat(merged.path("tooLarge").asBoolean()).isTrue();
        assertThat(merged.path("against").asDouble()).isGreaterThan(0.015);
        assertThat(merged.path("worst").path("x").asDouble()).isBetween(5.9, 6.6);
        assertThat(merged.path("worst").path("y").asDouble()).isBetween(1.4, 2.1);
        assertThat(merged.path("worst").path("hitBy").asString()).isEqualTo("other.log");
        assertThat(merged.path("worst").path("freeBy").asString()).isEqualTo("room.log");

        Ended text = rsal.run("map", "room.log", "other.log", "--out", "text", "--despite-contradictions");
        assertThat(text.out()).contains("they contradict each other", "is more than 1.5%", "most of it at (6.");
    }

    @Test
    void joinsNoMapsThatNothingShowsToShareAPlaceWhateverIsAsked() throws Exception {
        Files.writeString(folder.resolve("scan.log"), RoomLog.part(0, 0, Pose2d.ORIGIN));

        Ended ended = rsal.run("map", "room.log", "scan.log", "--out", "both", "--despite-contradictions");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.INVALID);
        assertThat(ended.err())
                .contains("scan.log", "No place is found", "that of 'room.log'")
                .doesNotContain("contradict");
    }

    @Test
    @LongTest
    void reportsWhereEachOfThreeMapsLiesWhenAllAreJoined() throws Exception {
        Files.writeString(folder.resolve("second.log"), RoomLog.part(10, 40, new Pose2d(30, -7, 2)));
        Files.writeString(folder.resolve("third.log"), RoomLog.part(0, 30, new Pose2d(-8, 4, 1)));

        Ended ended = rsal.run("map", "room.log", "second.log", "third.log", "--out", "all", "--json");

        assertThat(ended.code()).as(ended.err()).isEqualTo(Exit.SUCCESS);
        JsonNode merged = new JsonMapper().readTree(ended.out()).path("merged");
        for (int i = 0; i < 2; i++) {
            String log = List.of("second", "third").get(i);
            assertThat(rsal.run("map", log + ".log", "--out", log).code()).isEqualTo(Exit.SUCCESS);
            Pose2d right = lastOf("all/trajectory-%d.txt".formatted(i + 2))
                    .compose(lastOf(log + "/trajectory.txt").inverse());
            JsonNode reported = merged.path(i);
            var pose = new Pose2d(
                    reported.path("x").asDouble(),
                    reported.path("y").asDouble(),
                    Math.toRadians(reported.path("degrees").asDouble()));
            assertThat(pose.isNear(right, 1e-5, 1e-6))
                    .as("%s told, %s written", pose, right)
                    .isTrue();
        }
    }

    private Pose2d lastOf(String trajectory) throws IOException {
        String[] words =
                Files.readAllLines(folder.resolve(trajectory)).getLast().split(" ", -1);
        return new Pose2d(
                Double.parseDouble(words[1]),
                Double.parseDouble(words[2]),
                2 * Math.atan2(Double.parseDouble(words[6]), Double.parseDouble(words[7])));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            map room.log                                          | --out              | 2
            map --out x                                           | LOG                | 2
            map room.log --out x --odometry-noise 1               | '1'                | 2
            map room.log --out x --resolution 0                   | --resolution       | 2
            map room.log room.log --out x --known-poses           | --known-poses      | 2
            map room.log --out x --known-poses --no-reference     | --no-reference     | 2
            map room.log room.log --out x --reference room.log    | --reference        | 2
            map room.log --out x --despite-contradictions         | --despite-contradictions | 2
            map room.log --out x --seed 1.5                       | '1.5' is not a whole | 2
            map room.log --out x --max-range 0                    | --max-range must be | 2
            map room.log --out /proc/x                            | /proc/x: Nothing can be written | 3
            map none.log --out x                                  | none.log           | 3
            map room.log --out room.log                           | not a folder       | 3
            map room.log --out x --reference none.log             | none.log           | 3
            """)
    void refusesWhatItCannotDo(String line, String expected, int code) throws Exception {
        Ended ended = rsal.run(line.split(" "));
        assertThat(ended.code()).as(ended.err()).isEqualTo(code);
        assertThat(ended.err()).contains(expected).doesNotContain("\tat ");
        assertThat(ended.out()).isEmpty();
    }
}
