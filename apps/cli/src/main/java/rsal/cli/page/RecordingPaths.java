package rsal.cli.page;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/// Where recordings of one run after the other go, and what became of them.
final class RecordingPaths {
    private RecordingPaths() {}

    /// That of the first run is the one that was named; those of further runs are not there yet: `run-2.mcap`.
    ///
    /// @param ending that stays at the end of names; empty for folders
    /// @param run 1 for the first
    static Path of(Path named, String ending, int run) {
        if (run == 1) {
            return named;
        }
        String name = String.valueOf(named.getFileName());
        String stem = name.endsWith(ending) ? name.substring(0, name.length() - ending.length()) : name;
        Path next;
        int number = run;
        do {
            next = named.resolveSibling(stem + "-" + number + ending);
        } while (Files.exists(next) && number++ < Integer.MAX_VALUE);
        return next;
    }

    /// @param why the recording is not whole; empty when it is
    static void report(PrintWriter err, Path path, Optional<IOException> why) {
        err.println(why.map(e -> "rsal: The recording '%s' is incomplete: %s. Maybe the disk is full."
                        .formatted(path, e.getMessage()))
                .orElse("Recorded to " + path));
    }
}
