package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.LiveRun;
import rsal.engine.RunBuilder;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

class RobotRecordingsTest {
    private final StringWriter reported = new StringWriter();

    @TempDir
    private Path folder;

    private void run(Optional<String> recorded) throws Exception {
        try (var recordings = new RobotRecordings("ros2", recorded, false, new PrintWriter(reported))) {
            RunBuilder builder = LiveRun.of(Scenario.load("hunt-and-prey")
                    .plan(RunOptions.NONE.withSpeed(Double.POSITIVE_INFINITY).withLimit(Duration.ofSeconds(1))));
            recordings.begin().ifPresent(builder::recorder);
            try (LiveRun run = builder.start()) {
                recordings.began(run);
                run.result().toCompletableFuture().get(100, TimeUnit.SECONDS);
                recordings.end(run);
            }
        }
    }

    @Test
    void whatIsNotRecordedIsNotReported() throws Exception {
        run(Optional.empty());
        assertThat(reported.toString()).isEmpty();
    }

    @Test
    void theFolderOfARecordingIsReported() throws Exception {
        String bag = folder.resolve("bag").toString();
        run(Optional.of(bag));
        assertThat(reported.toString()).isEqualTo("Recorded to " + bag + System.lineSeparator());
    }
}
