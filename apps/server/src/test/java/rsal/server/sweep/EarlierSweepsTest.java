package rsal.server.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import rsal.experiment.Design;
import rsal.experiment.Manifest;
import rsal.experiment.Sweep;
import rsal.experiment.SweepFolder;
import rsal.server.Errand;
import rsal.server.message.Messages.EarlierSweep;

@Timeout(60)
class EarlierSweepsTest {
    @TempDir
    private Path folder;

    /// Of the threads that answer requests there are few, and an emergency stop needs one.
    @Test
    @DisabledOnOs(OS.WINDOWS) // no pipes that are files
    void letsFewWaitWhileASweepIsSlowToRead() throws Exception {
        Path sweep = folder.resolve("slow");
        var design = new Design(List.of("pair"), List.of(), Map.of(), List.of(1L), Optional.of(Duration.ofSeconds(1)));
        var session = new Manifest.Session(
                "2026-01-02T03:04:05Z", "errand.yaml", List.of("rsal"), 1, Manifest.Machine.here("0"));
        SweepFolder.create(sweep, Sweep.of(Errand.plan().scenario(), design), session)
                .close();
        var sweeps = new EarlierSweeps(folder);
        assertThat(sweeps.list(Optional.empty())).hasSize(1);
        Path rows = sweep.resolve(SweepFolder.ROWS);
        Files.delete(rows);
        assertThat(new ProcessBuilder("mkfifo", rows.toString()).start().waitFor())
                .isZero(); // whoever opens it waits until somebody writes
        try (var threads = Executors.newVirtualThreadPerTaskExecutor()) {
            var asking = new ExecutorCompletionService<List<EarlierSweep>>(threads);
            for (int i = 0; i < 5; i++) {
                var _ = asking.submit(() -> sweeps.list(Optional.empty()));
            }
            assertThatExceptionOfType(ExecutionException.class)
                    .isThrownBy(() -> asking.take().get())
                    .withMessageContaining("Others request earlier sweeps at the same time.");
            try (OutputStream _ = Files.newOutputStream(rows)) {
                Files.delete(rows); // for those that open it later
            }
            for (int i = 1; i < 5; i++) {
                assertThat(asking.take().get()).hasSize(1);
            }
        }
    }
}
