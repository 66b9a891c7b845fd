package rsal.experiment;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import rsal.settings.InvalidSettings;

/// What is soon known of an experiment, without reading its rows.
///
/// @param ended how many of its runs have rows
public record ExperimentOutline(Manifest manifest, long ended) {
    /// Reads it from a folder, also while the experiment goes on.
    ///
    /// @throws InvalidSettings when there is none, or it can't be read
    /// @throws UncheckedIOException when the rows can't be counted
    public static ExperimentOutline read(Path folder) {
        return new ExperimentOutline(SweepFolder.manifest(folder), SweepFolder.countRows(folder));
    }

    /// How many runs there are to be.
    public long runs() {
        return manifest.subject().design().runs();
    }
}
