package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.show.RecordingFile;
import rsal.recording.Recording;

/// A run that is recorded is ended by a signal (SIGTERM) soon after it was started: there is no recording, or a whole
/// one.
class EarlySignalIT {
    @TempDir
    Path folder;

    private Process started() throws Exception {
        return new Rsal(folder).start("run", "hunt-and-prey", "--headless", "--speed", "max", "--record", "r.mcap");
    }

    private void ended(Process run) throws Exception {
        run.destroy();
        assertThat(run.waitFor(60, TimeUnit.SECONDS)).isTrue();
        Path file = folder.resolve("r.mcap");
        if (Files.exists(file)) {
            try (Recording recording = RecordingFile.open(file.toString(), true)) {
                assertThat(recording.file().damage()).isEmpty();
            }
        }
    }

    @Test
    void beforeAnythingIsSaid() throws Exception {
        ended(started());
    }

    @Test
    void whenItIsAskedToBegin() throws Exception {
        Process run = started();
        assertThat(run.errorReader().lines().anyMatch(line -> line.startsWith("Running ")))
                .isTrue();
        ended(run);
    }
}
