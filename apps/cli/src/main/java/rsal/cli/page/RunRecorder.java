package rsal.cli.page;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.cli.terminal.Destination;
import rsal.engine.LiveRun;
import rsal.engine.report.RunObserver;
import rsal.engine.report.RunResult;
import rsal.recording.Backlog;
import rsal.recording.Origin;
import rsal.recording.Recorder;
import rsal.scenario.RunPlan;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.time.AllowedToReadWallClock;

/// Records runs where that is wanted: the first to the file that was named, others beside it. All methods may be called
/// from any thread.
@AllowedToReadWallClock("Recordings are written about once a second.")
final class RunRecorder implements AutoCloseable {
    private static final String ENDING = ".mcap";

    private final Optional<Path> file;
    private final boolean force;
    private final boolean headless;
    private final PrintWriter err;
    private volatile Counted counted = new Counted(Recorder.Tally.NONE, Optional.empty());

    // under the lock of this
    private int runs;
    private @Nullable Recorder recorder;
    private @Nullable LiveRun run;
    private @Nullable Path recorded;
    private boolean failed;
    private boolean over;

    /// What recordings have come to.
    ///
    /// @param ended all that have ended
    /// @param open the one that is under way
    private record Counted(Recorder.Tally ended, Optional<Recorder> open) {
        Recorder.Tally all() {
            return open.map(under -> ended.plus(under.tally())).orElse(ended);
        }
    }

    private RunRecorder(Optional<Path> file, boolean force, boolean headless, PrintWriter err) {
        this.file = file;
        this.force = force;
        this.headless = headless;
        this.err = err;
    }

    /// @param file empty when nothing is to be recorded
    /// @param headless whether nobody watches, so that the run may wait for the file
    /// @param err told what became of each recording
    static RunRecorder to(Optional<String> file, boolean force, boolean headless, PrintWriter err) {
        return new RunRecorder(file.map(Destination::path), force, headless, err);
    }

    /// Begins to record the next run, when the recording of the one before has ended.
    ///
    /// @return whom it is to tell; empty when nothing is to be recorded
    /// @throws InvalidSettings when the file can't be written, or is there and may not be lost
    synchronized Optional<RunObserver> begin(Origin origin) {
        if (file.isEmpty() || over) {
            return Optional.empty();
        }
        end();
        runs++;
        Path path = RecordingPaths.of(file.get(), ENDING, runs);
        boolean waits = headless && origin.plan().clock() == RunPlan.Clock.SIMULATED;
        try {
            var next = Recorder.begin(
                    path,
                    force && runs == 1,
                    origin,
                    waits ? Backlog.Behind.WAIT : Backlog.Behind.DROP,
                    System::nanoTime);
            recorder = next;
            counted = new Counted(counted.ended(), Optional.of(next));
            recorded = path;
            return Optional.of(next.observer());
        } catch (FileAlreadyExistsException _) {
            throw new InvalidSettings(
                    Location.of(path.toString()),
                    "The file is there already.",
                    "Name another, or overwrite it by '--force'.");
        } catch (IOException e) {
            throw new InvalidSettings(
                    Location.of(path.toString()),
                    "No recording can be written to this file (%s: %s)."
                            .formatted(e.getClass().getSimpleName(), e.getMessage()),
                    "Name one that you may write to, on a disk that has room.");
        }
    }

    /// The run that tells has begun.
    synchronized void began(LiveRun begun) {
        run = begun;
    }

    /// A run has ended: ends its recording, unless another has begun since, and tells what became of it.
    synchronized void end(LiveRun over) {
        if (over.equals(run)) {
            end();
        }
    }

    private void end() {
        Recorder ended = recorder;
        endRecording();
        if (ended == null) {
            return;
        }
        RecordingPaths.report(err, Objects.requireNonNull(recorded), ended.failure());
        if (ended.dropped() > 0) {
            err.println("The disk was too slow: %d states of the run were not recorded.".formatted(ended.dropped()));
        }
    }

    /// The results of all recordings so far; empty when nothing is to be recorded. Does not wait for one that ends.
    Optional<Recorder.Tally> tally() {
        return file.map(_ -> counted.all());
    }

    /// Whether any recording is not whole.
    synchronized boolean hasFailed() {
        return failed;
    }

    /// Ends the recording that is under way; no other begins.
    @Override
    public synchronized void close() {
        over = true;
        endRecording();
    }

    private void endRecording() {
        Recorder open = recorder;
        LiveRun recordedRun = run;
        if (open == null) {
            return;
        }
        if (recordedRun != null) {
            recordedRun
                    .result()
                    .toCompletableFuture()
                    .handle((result, _) -> Optional.<RunResult>ofNullable(result))
                    .getNow(Optional.empty())
                    .ifPresent(open::ended);
        }
        open.close();
        failed |= open.failure().isPresent();
        counted = new Counted(counted.all(), Optional.empty());
        recorder = null;
        run = null;
    }
}
