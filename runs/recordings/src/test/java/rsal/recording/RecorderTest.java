package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.mcap.McapFile;
import rsal.recording.Verification.Finding;
import rsal.recording.proto.ProtoReader;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Rounds;

class RecorderTest {
    private static final String HUNT = "hunt-and-prey";

    @TempDir
    Path folder;

    @LongTest
    @Test
    void aRunOfAnEditedTextHasThatTextAndCanBeRunAgain() throws Exception {
        Scenario patrol = Scenario.load("patrol");
        String text = patrol.text().replaceFirst("scenario: patrol", "scenario: rounds");
        RunPlan plan = patrol.edited(text)
                .plan(RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY).withLimit(Duration.ofSeconds(5)));
        Path file = folder.resolve("edited.mcap");
        RunResult result = Recorded.run(plan, file);
        try (Recording recording = Recording.open(file.toString(), true)) {
            RunPlan again = recording.plan(false);
            assertThat(again.scenario().name()).isEqualTo("rounds");
            assertThat(again.scenario().text()).isEqualTo(text);
            RunResult second =
                    LiveRun.start(again).result().toCompletableFuture().get(100, TimeUnit.SECONDS);
            assertThat(second.eventHash()).isEqualTo(result.eventHash());
        }
    }

    @Test
    void recordingChangesNothingAndTheSameRunIsTheSameRecording() throws Exception {
        int seconds = Rounds.of(8, 20);
        RunPlan plan = Recorded.plan(HUNT, 7, seconds);
        RunResult without = LiveRun.start(plan).result().toCompletableFuture().get(100, TimeUnit.SECONDS);
        Path first = folder.resolve("first.mcap");
        Path second = folder.resolve("second.mcap");
        assertThat(Recorded.run(plan, first).eventHash()).isEqualTo(without.eventHash());
        assertThat(Recorded.run(plan, second).eventHash()).isEqualTo(without.eventHash());

        assertThat(messages(first)).hasSizeGreaterThan(1000).isEqualTo(messages(second));
        try (Recording recording = Recording.open(first.toString(), true)) {
            assertThat(recording.file().damage()).isEmpty();
            assertThat(recording.result())
                    .containsEntry("eventHash", without.eventHash())
                    .containsEntry("outcome", without.outcome())
                    .containsEntry("droppedStates", "0");
            assertThat(recording.run()).containsEntry("seed", "7").containsEntry("scenario", HUNT);
            assertThat(recording.duration()).isEqualTo(Duration.ofSeconds(seconds));
            assertThat(recording.file().channels())
                    .extracting(channel -> channel.topic())
                    .contains("/map", "/tf", "/state", "/events", "/log", "/messages", "/agents", "/world", "/robots");
        }
    }

    @Test
    void aRecordingIsRunAgainAndIsTheSame() throws Exception {
        Path file = folder.resolve("run.mcap");
        Recorded.run(Recorded.plan(HUNT, 3, 10), file);
        assertThat(verify(file)).isInstanceOfSatisfying(Finding.Same.class, same -> {
            assertThat(same.isWhole()).isTrue();
            assertThat(same.until()).isEqualTo(Duration.ofSeconds(10));
            assertThat(same.compared().events()).isPositive();
            assertThat(same.compared().messages()).isGreaterThan(same.compared().events());
            assertThat(same.compared().states()).isBetween(100, 101); // one each 0.1 s
        });
    }

    @Test
    void reportsHowMuchItHasWritten() throws Exception {
        Path file = folder.resolve("run.mcap");
        RunPlan plan = Recorded.plan(HUNT, 3, 5);
        Recorder recorder = Recorded.begin(plan, file);
        try (recorder) {
            LiveRun.of(plan)
                    .observer(recorder.observer())
                    .start()
                    .result()
                    .toCompletableFuture()
                    .get(100, TimeUnit.SECONDS);
        }
        assertThat(recorder.tally()).isEqualTo(new Recorder.Tally(Files.size(file), 0, 0));
        assertThat(recorder.tally().plus(new Recorder.Tally(1, 2, 3)))
                .isEqualTo(new Recorder.Tally(Files.size(file) + 1, 2, 3));
    }

    @LongTest
    @Test
    void whatIsCutOffIsComparedUpToThere() throws Exception {
        Path file = folder.resolve("run.mcap");
        Recorded.run(Recorded.plan(HUNT, 3, 20), file);
        byte[] bytes = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(bytes, bytes.length * 2 / 3));
        assertThat(verify(file)).isInstanceOfSatisfying(Finding.Same.class, same -> {
            assertThat(same.isWhole()).isFalse();
            assertThat(same.until()).isGreaterThan(Duration.ofSeconds(1));
        });
    }

    @Test
    void theFirstDifferenceIsReported() throws Exception {
        Path file = folder.resolve("run.mcap");
        Recorded.run(Recorded.plan(HUNT, 3, 10), Recorded.plan(HUNT, 4, 10), file);
        assertThat(verify(file)).isInstanceOf(Finding.Different.class);
    }

    @Test
    void robotsThatAreElsewhereAreNamedWithBothPoses() throws Exception {
        Path scenario = Files.writeString(folder.resolve("own.yaml"), """
                rsal: 1
                scenario: own
                world: {map: office}
                robots: {guard: {model: pioneer2dx, pose: [0, -1, 0], devices: {laser: urg04lx, pilot: {}}}}
                agents: {walk: {type: wander, robot: guard}}
                run: {stop: [{when: time > 20, outcome: success}]}
                """);
        Path file = folder.resolve("run.mcap");
        String own = scenario.toString();
        Recorded.run(Recorded.plan(own, 1, 20), Recorded.plan(own, 2, 20), file); // with other noise
        assertThat(verify(file)).isInstanceOfSatisfying(Finding.Different.class, different -> {
            assertThat(different.equalUntil()).isLessThan(different.time());
            assertThat(different.differences())
                    .singleElement()
                    .asString()
                    .matches("guard: (true pose|odometry|estimated pose) \\(.* rad\\) recorded, \\(.* rad\\) now");
        });
    }

    /// A scenario of one's own is in the file with all that it is made of.
    @Test
    void aRecordingNeedsNoOtherFile() throws Exception {
        Files.writeString(folder.resolve("room.yaml"), "drawing: |\n  #######\n  #.....#\n  #######\nresolution: 1\n");
        Path scenario = Files.writeString(folder.resolve("own.yaml"), """
                rsal: 1
                scenario: own
                world: {map: room.yaml}
                robots: {guard: {model: pioneer2dx, pose: [2, 1.5, 0], devices: {laser: urg04lx}}}
                run: {stop: [{when: time > 3, outcome: success}]}
                """);
        Path file = folder.resolve("run.mcap");
        Recorded.run(Recorded.plan(scenario.toString(), 1, 10), file);
        Files.delete(scenario);
        Files.delete(folder.resolve("room.yaml"));
        assertThat(verify(file)).isInstanceOf(Finding.Same.class);
    }

    @Test
    void posesAndScansAreThoseOfTheRun() throws Exception {
        Path file = folder.resolve("run.mcap");
        Recorded.run(Recorded.plan(HUNT, 7, 5), file);
        var scans = new ArrayList<Map<String, Object>>();
        var states = new ArrayList<Map<String, Object>>();
        try (McapFile mcap = McapFile.open(file)) {
            mcap.read(
                    channel -> channel.topic().endsWith("/scan"),
                    (_, _, _, _, data) -> scans.add(ProtoReader.read(Foxglove.LASER_SCAN, data)));
            mcap.read(
                    channel -> channel.topic().equals("/state"),
                    (_, _, _, _, data) -> states.add(ProtoReader.read(Own.STATE, data)));
        }
        assertThat(scans).isNotEmpty();
        assertThat((List<?>) scans.getFirst().get("ranges")).hasSizeGreaterThan(100);
        assertThat(states).hasSizeBetween(50, 52);
        assertThat(states.getLast().toString()).contains("hunter", "prey", "truth={x=");
    }

    @Test
    void aFileThatIsThereStays() throws Exception {
        Path file = Files.writeString(folder.resolve("run.mcap"), "precious");
        var origin = new Origin(Recorded.plan(HUNT, 7, 5), "test", "", Instant.EPOCH);
        assertThatThrownBy(() -> Recorder.begin(file, false, origin, Backlog.Behind.WAIT, System::nanoTime))
                .isInstanceOf(FileAlreadyExistsException.class);
        assertThat(file).hasContent("precious");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aFullDiskEndsTheRecordingAndNotTheRun() throws Exception {
        assertThatThrownBy(() -> Recorded.begin(Recorded.plan(HUNT, 7, 5), Path.of("/dev/full")))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("No space left");
    }

    /// Nobody writes: the newest states win, events stay, and the run waits for nobody.
    @Test
    void whatIsTooMuchIsDroppedAndCounted() throws Exception {
        RunPlan plan = Recorded.plan(HUNT, 7, 5);
        var origin = new Origin(plan, "test", "", Instant.EPOCH);
        var stuck = new StuckClock();
        Path file = folder.resolve("run.mcap");
        try (Recorder recorder = Recorder.begin(file, true, origin, Backlog.Behind.DROP, stuck)) {
            stuck.stick();
            Snapshot state = LiveRun.start(plan).snapshot();
            for (int i = 0; i < 100; i++) {
                recorder.observer().sees(state, "" + i);
            }
            assertThat(recorder.dropped()).isBetween(80L, 100L);
            stuck.letGo();
        }
        try (McapFile mcap = McapFile.open(file)) {
            var hashes = new ArrayList<Object>();
            mcap.read(
                    channel -> channel.topic().equals("/state"),
                    (_, _, _, _, data) ->
                            hashes.add(ProtoReader.read(Own.STATE, data).get("hash")));
            assertThat(hashes).endsWith("98", "99").hasSizeLessThan(20);
        }
    }

    private static Finding verify(Path file) throws Exception {
        try (Recording recording = Recording.open(file.toString(), false)) {
            return Verification.begin(recording, recording.plan(false))
                    .toCompletableFuture()
                    .get(100, TimeUnit.SECONDS);
        }
    }

    private static List<String> messages(Path file) throws IOException {
        var all = new ArrayList<String>();
        try (McapFile mcap = McapFile.open(file)) {
            mcap.read(_ -> true, (channel, sequence, logTime, publishTime, data) -> {
                byte[] bytes = new byte[data.remaining()];
                data.get(bytes);
                all.add("%s %d %d %d %s"
                        .formatted(
                                channel.topic(),
                                sequence,
                                logTime,
                                publishTime,
                                bytes.length < 2000 ? HexFormat.of().formatHex(bytes) : "" + Arrays.hashCode(bytes)));
            });
        }
        return all;
    }
}
