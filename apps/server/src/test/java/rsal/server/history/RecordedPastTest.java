package rsal.server.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.bdi.Mind;
import rsal.engine.LiveRun;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunObserver;
import rsal.engine.report.RunResult;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.recording.Backlog;
import rsal.recording.Origin;
import rsal.recording.Playback;
import rsal.recording.Recorder;
import rsal.recording.Recording;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.server.description.Descriptions;
import rsal.server.frame.Feed;
import rsal.server.frame.FrameEncoder;
import rsal.server.frame.Moment;
import rsal.server.frame.ObjectTracker;
import rsal.server.live.PlaybackCursor;
import rsal.server.message.Json;
import rsal.server.message.Messages.LookBack;
import rsal.server.message.Messages.ServerMessage;
import rsal.testkit.Trials;

public class RecordedPastTest {
    private static final int ROBOTS_AT = 32; // in a frame; what is before depends on the viewer, but for the time

    @TempDir
    Path folder;

    @Trials({"distribution", "hunt-and-prey"})
    void showsWhatALiveFeedShowed(String scenario) throws Exception {
        Path file = folder.resolve("run.mcap");
        List<Snapshot> seen = record(plan(scenario, 15), file);
        var encoder = new FrameEncoder();
        var surveyor = new ObjectTracker(RecordedPast.RUN);
        List<String> robots =
                seen.getLast().team().stream().map(mate -> mate.spec().id()).toList();
        try (Playback playback = open(file)) {
            var past = new RecordedPast(playback, "run.mcap");
            assertThat(past.robots()).isEqualTo(robots.size());
            for (Snapshot then : seen) {
                surveyor.look(then.things());
                byte[] live = encoder.encode(RecordedPast.RUN, 1, then, robots, surveyor.moved());
                Moment now = past.at(then.time());
                assertThat(now.time()).isEqualTo(then.time());
                assertThat(robotsOf(now.frame())).as("at %s", then.time()).isEqualTo(robotsOf(live));
                assertThat(now.things().all()).isEqualTo(surveyor.roster().all());
                if (then.outcome().isEmpty()) {
                    assertThat(now.details())
                            .isEqualTo(Json.write(ServerMessage.of(
                                    Descriptions.details(RecordedPast.RUN, then, new CompletableFuture<RunResult>()))));
                }
            }
        }
    }

    private static byte[] robotsOf(byte[] frame) {
        return Arrays.copyOfRange(frame, ROBOTS_AT, frame.length);
    }

    /// With others who look elsewhere.
    @Test
    void seekingShowsWhatPlayingUpToThereDoes() throws Exception {
        Path file = folder.resolve("run.mcap");
        record(plan("find-and-collect", 20), file);
        try (Playback first = open(file);
                Playback second = open(file)) {
            var played = new PlaybackCursor(new RecordedPast(first, "run.mcap"));
            var past = new RecordedPast(second, "run.mcap");
            past.at(Duration.ofDays(1));
            var random = new Random(4);
            past.at(Duration.ZERO); // things are told as they were first seen
            for (int i = 0; i < 150; i++) {
                played.pass(Duration.ofMillis(100));
                Moment sought = past.at(played.time());
                assertThat(robotsOf(sought.frame())).isEqualTo(robotsOf(played.frame()));
                assertThat(sought.details()).isEqualTo(played.details(0));
                past.at(Duration.ofMillis(random.nextInt(20_000)));
            }
        }
    }

    @Test
    void aViewerStepsPlaysAndStopsAtTheEnd() throws Exception {
        Path file = folder.resolve("run.mcap");
        record(plan("hunt-and-prey", 5), file);
        try (Playback playback = open(file)) {
            var past = new RecordedPast(playback, "run.mcap");
            var looking = new PlaybackCursor(past);
            assertThat(looking.time()).isEqualTo(past.from());
            looking.pass(Duration.ofMillis(500));
            assertThat(time(looking)).isEqualTo(0.6); // the first state is of the first step
            assertThat(flags(looking) & FrameEncoder.PAST).isNotZero();
            assertThat(flags(looking) & FrameEncoder.PAUSED).isZero();

            assertThat(looks(looking)).isEqualTo(1);
            PlaybackCursor stepped = PlaybackCursor.at(past, wish(1.0, 1, false, "1"), looking.time(), 1);
            assertThat(time(stepped)).isEqualTo(1.1);
            assertThat(flags(stepped) & FrameEncoder.PAUSED).isNotZero();
            stepped.pass(Duration.ofSeconds(1));
            assertThat(time(stepped)).isEqualTo(1.1);
            assertThat(time(PlaybackCursor.at(past, wish(1.0, -1, false, "1"), Duration.ZERO, 1)))
                    .isEqualTo(0.9);

            PlaybackCursor fast = PlaybackCursor.at(past, wish(1.0, 0, true, "max"), Duration.ZERO, 1);
            fast.pass(Duration.ofMillis(50));
            assertThat(time(fast)).isEqualTo(5);
            assertThat(flags(fast) & FrameEncoder.PAUSED).isNotZero();
            assertThat(flags(fast) & FrameEncoder.ENDED).isNotZero();
            assertThat(fast.details(0)).contains("\"ending\":{\"outcome\":\"limit\"");
            for (double nowhere : new double[] {-7, 1e300, Double.NaN, Double.NEGATIVE_INFINITY}) {
                assertThat(time(PlaybackCursor.at(past, wish(nowhere, 0, true, "1"), Duration.ZERO, 1)))
                        .isBetween(0.0, 5.0);
            }
        }
    }

    private static LookBack wish(double time, int step, boolean playing, String speed) {
        return new LookBack(
                Optional.of(false), Optional.of(time), Optional.of(step), Optional.of(playing), Optional.of(speed));
    }

    private static double time(Feed feed) {
        return header(feed).getDouble(16);
    }

    @Test
    void aViewerIsInformedWhetherItSeesWhatFollows() throws Exception {
        Path file = folder.resolve("run.mcap");
        record(plan("hunt-and-prey", 5), file);
        try (Playback playback = open(file)) {
            var past = new RecordedPast(playback, "run.mcap");
            PlaybackCursor there = PlaybackCursor.at(past, wish(2.0, 0, true, "1"), Duration.ZERO, 7);
            assertThat(looks(there)).isEqualTo(8);
            there.pass(Duration.ofSeconds(1));
            assertThat(looks(there)).isEqualTo(8);
            assertThat(looks(PlaybackCursor.at(past, onFrom(0), there.time(), 8)))
                    .isEqualTo(8);
            assertThat(looks(PlaybackCursor.at(past, onFrom(1), there.time(), 8)))
                    .isEqualTo(8);
            assertThat(looks(PlaybackCursor.at(past, onFrom(-1), there.time(), 8)))
                    .isEqualTo(9);
            assertThat(looks(PlaybackCursor.at(past, wish(2.1, 0, false, "8"), there.time(), 0xffff)))
                    .isZero();
        }
    }

    /// Without a time.
    private static LookBack onFrom(int step) {
        return new LookBack(
                Optional.of(false), Optional.empty(), Optional.of(step), Optional.of(true), Optional.empty());
    }

    private static int looks(PlaybackCursor looking) {
        return flags(looking) >>> FrameEncoder.LOOKS_AT;
    }

    private static int flags(Feed feed) {
        return header(feed).getInt(FrameEncoder.FLAGS_AT);
    }

    private static ByteBuffer header(Feed feed) {
        return ByteBuffer.wrap(feed.frame()).order(ByteOrder.LITTLE_ENDIAN);
    }

    public static RunPlan plan(String scenario, int seconds) {
        return Scenario.load(scenario)
                .plan(RunOptions.NONE
                        .withSeed(7)
                        .withSpeed(Double.POSITIVE_INFINITY)
                        .withLimit(Duration.ofSeconds(seconds)));
    }

    public static Playback open(Path file) throws Exception {
        return Playback.of(Recording.open(file.toString(), false));
    }

    /// @return what was recorded, in the order in which it was
    public static List<Snapshot> record(RunPlan plan, Path file) throws Exception {
        return record(plan, file, _ -> {});
    }

    /// @param meddling what people do as it has begun
    public static List<Snapshot> record(RunPlan plan, Path file, Consumer<LiveRun> meddling) throws Exception {
        var origin = new Origin(plan, "rsal test", "rsal run", Instant.EPOCH);
        var seen = new ArrayList<Snapshot>();
        try (Recorder recorder = Recorder.begin(file, true, origin, Backlog.Behind.WAIT, System::nanoTime)) {
            LiveRun run = LiveRun.of(plan)
                    .observer(new Seen(recorder.observer(), seen))
                    .start();
            meddling.accept(run);
            RunResult result = run.result().toCompletableFuture().get(100, TimeUnit.SECONDS);
            recorder.ended(result);
        }
        return seen;
    }

    /// Keeps what it passes on.
    private record Seen(RunObserver next, List<Snapshot> snapshots) implements RunObserver {
        @Override
        public Duration period() {
            return next.period();
        }

        @Override
        public void sees(Snapshot now, String hash) {
            snapshots.add(now);
            next.sees(now, hash);
        }

        @Override
        public void looksInto(Duration time, Map<String, Mind.View> minds) {
            next.looksInto(time, minds);
        }

        @Override
        public void happened(RunEvent event, String hash) {
            next.happened(event, hash);
        }

        @Override
        public void heard(SentMessage message, Object content) {
            next.heard(message, content);
        }
    }
}
