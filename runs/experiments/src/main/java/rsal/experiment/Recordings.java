package rsal.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import rsal.engine.report.RunObserver;
import rsal.engine.report.RunResult;
import rsal.scenario.RunPlan;

/// Who records the runs of an experiment, beside their rows.
@FunctionalInterface
public interface Recordings {
    /// Nobody does.
    Recordings NONE = (_, _) -> new Recording() {
        @Override
        public Optional<RunObserver> observer() {
            return Optional.empty();
        }

        @Override
        public void ended(RunResult how) {}

        @Override
        public void close() {}
    };

    /// Begins to record a run. Called by several threads, each for another run. What there is of it from an earlier
    /// session, in which it came to no row, is lost.
    ///
    /// @throws IOException when it can't be written
    Recording begin(Trial trial, RunPlan plan) throws IOException;

    /// Where that of a run is, in the folder of its experiment: `recordings/7.mcap`.
    ///
    /// @param run its number
    static Path file(Path folder, int run) {
        return folder.resolve("recordings").resolve(run + ".mcap");
    }

    /// One run's.
    interface Recording extends AutoCloseable {
        /// Whom the run is to tell.
        Optional<RunObserver> observer();

        /// To be called before [#close], for how it ended to be recorded.
        void ended(RunResult how);

        /// Returns when it is there as a whole.
        ///
        /// @throws IOException when it can't be
        @Override
        void close() throws IOException;
    }
}
