package rsal.cli.sweep;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;
import rsal.cli.terminal.Build;
import rsal.engine.report.RunObserver;
import rsal.engine.report.RunResult;
import rsal.experiment.Recordings;
import rsal.experiment.Trial;
import rsal.recording.Backlog;
import rsal.recording.Origin;
import rsal.recording.Recorder;
import rsal.scenario.RunPlan;
import rsal.time.AllowedToReadWallClock;

/// Records the runs of a sweep, each to a file of its own. Runs wait for their files, so that nothing is left out.
///
/// @param folder of the sweep
/// @param command as it was typed
@AllowedToReadWallClock("Recordings are written about once a second, and say when they were made.")
record SweepRecordings(Path folder, String command) implements Recordings {
    @Override
    public Recording begin(Trial trial, RunPlan plan) throws IOException {
        Path file = Recordings.file(folder, trial.number());
        Files.createDirectories(file.resolveSibling("."));
        var origin = new Origin(plan, Build.name(), command, Instant.now());
        return new Recorded(Recorder.begin(file, true, origin, Backlog.Behind.WAIT, System::nanoTime));
    }

    private record Recorded(Recorder recorder) implements Recording {
        @Override
        public Optional<RunObserver> observer() {
            return Optional.of(recorder.observer());
        }

        @Override
        public void ended(RunResult how) {
            recorder.ended(how);
        }

        @Override
        public void close() throws IOException {
            recorder.close();
            Optional<IOException> failure = recorder.failure();
            if (failure.isPresent()) {
                throw failure.get();
            }
        }
    }
}
