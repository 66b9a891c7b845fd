package rsal.cli.page;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.cli.terminal.Build;
import rsal.cli.terminal.Destination;
import rsal.engine.LiveRun;
import rsal.scenario.installed.Providers;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.system.RobotRecorder;
import rsal.system.RobotRecorderProvider;

/// Records the robots of runs for programs of another robot system, where that is wanted: those of the first run in the
/// folder that was named, others beside it. All methods may be called from any thread.
final class RobotRecordings implements AutoCloseable {
    private final String system;
    private final Optional<Path> folder;
    private final boolean force;
    private final PrintWriter err;

    // under the lock of this
    private int runs;
    private @Nullable RobotRecorder recorder;
    private @Nullable LiveRun run;
    private @Nullable Path recorded;
    private boolean failed;

    /// @param system the key of its [RobotRecorderProvider]
    /// @param folder empty when nothing is to be recorded
    /// @param err told what became of each recording
    RobotRecordings(String system, Optional<String> folder, boolean force, PrintWriter err) {
        this.system = system;
        this.folder = folder.map(Destination::path);
        this.force = force;
        this.err = err;
    }

    /// Begins to record the next run, when the recording of the one before has ended.
    ///
    /// @return who is to record it; empty when nothing is to be recorded
    /// @throws InvalidSettings when the folder can't be written, or is there and may not be lost
    synchronized Optional<RobotRecorder> begin() {
        if (folder.isEmpty()) {
            return Optional.empty();
        }
        end();
        runs++;
        Path path = RecordingPaths.of(folder.get(), "", runs);
        try {
            RobotRecorder next = provider().begin(path, force && runs == 1, Build.name());
            recorder = next;
            recorded = path;
            return Optional.of(next);
        } catch (FileAlreadyExistsException _) {
            throw new InvalidSettings(
                    Location.of(path.toString()),
                    "The folder is not empty.",
                    force
                            ? "Name another folder, as there is no recording in it that '--force' could overwrite."
                            : "Name another folder, or overwrite the recording in it by '--force'.");
        } catch (IOException e) {
            throw new InvalidSettings(
                    Location.of(path.toString()),
                    "No recording can be written to this folder (%s: %s)."
                            .formatted(e.getClass().getSimpleName(), e.getMessage()),
                    "Name one that you may write to, on a disk that has room.");
        }
    }

    private RobotRecorderProvider provider() {
        Map<String, RobotRecorderProvider> all =
                Providers.byKey(RobotRecorderProvider.class, RobotRecorderProvider::key);
        return Optional.ofNullable(all.get(system))
                .orElseThrow(() -> new InvalidSettings(
                        Location.of(system), "Nothing records robots for this system.", "Maybe it is not installed."));
    }

    /// The run that is recorded has begun.
    synchronized void began(LiveRun begun) {
        run = begun;
    }

    /// A run has ended, and with it its recording, unless another has begun since: says what became of it.
    synchronized void end(LiveRun over) {
        if (over.equals(run)) {
            end();
        }
    }

    private void end() {
        RobotRecorder open = recorder;
        if (open == null) {
            return;
        }
        Optional<IOException> why = close(open);
        recorder = null;
        run = null;
        RecordingPaths.report(err, Objects.requireNonNull(recorded), why);
    }

    private Optional<IOException> close(@Nullable RobotRecorder open) {
        if (open == null) {
            return Optional.empty();
        }
        open.close();
        failed |= open.failure().isPresent();
        return open.failure();
    }

    /// Whether any recording is not whole.
    synchronized boolean hasFailed() {
        return failed;
    }

    /// Ends the recording that is under way.
    @Override
    public synchronized void close() {
        close(recorder);
        recorder = null;
        run = null;
    }
}
