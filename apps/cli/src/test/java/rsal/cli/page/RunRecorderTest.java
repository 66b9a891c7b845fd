package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.LiveRun;
import rsal.recording.Origin;
import rsal.recording.Recorder;
import rsal.recording.Recording;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

class RunRecorderTest {
    private final StringWriter reported = new StringWriter();

    @TempDir
    Path folder;

    /// The page starts a run in the place of another on a thread of its own: the end of the first is told to the
    /// recorder when that of the second may be under way.
    @Test
    void theEndOfARunEndsItsOwnRecordingOnly() throws Exception {
        Path file = folder.resolve("run.mcap");
        Path next = folder.resolve("run-2.mcap");
        RunPlan plan = Scenario.load("hunt-and-prey")
                .plan(RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY).withLimit(Duration.ofSeconds(3)));
        try (RunRecorder recorder =
                RunRecorder.to(Optional.of(file.toString()), false, true, new PrintWriter(reported))) {
            LiveRun first = record(plan, recorder);
            LiveRun second = record(plan, recorder);
            assertThat(reported.toString()).contains("Recorded to " + file);
            recorder.end(first);
            assertThat(reported.toString()).doesNotContain(next.toString());
            recorder.end(second);
            assertThat(reported.toString()).contains("Recorded to " + next);
            assertThat(recorder.tally()).contains(new Recorder.Tally(Files.size(file) + Files.size(next), 0, 0));
        }
        for (Path each : new Path[] {file, next}) {
            try (Recording recording = Recording.open(each.toString(), true)) {
                assertThat(recording.duration()).isEqualTo(Duration.ofSeconds(3));
                assertThat(recording.result()).containsKey("eventHash");
            }
        }
    }

    private static LiveRun record(RunPlan plan, RunRecorder recorder) throws Exception {
        var origin = new Origin(plan, "rsal test", "rsal run", Instant.EPOCH);
        LiveRun run =
                LiveRun.of(plan).observer(recorder.begin(origin).orElseThrow()).start();
        recorder.began(run);
        run.result().toCompletableFuture().get(100, TimeUnit.SECONDS);
        return run;
    }
}
