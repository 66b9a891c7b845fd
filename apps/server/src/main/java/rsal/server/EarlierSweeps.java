package rsal.server;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.experiment.Findings;
import rsal.experiment.Manifest;
import rsal.experiment.SweepFolder;
import rsal.experiment.report.Report;
import rsal.experiment.report.ShellWords;
import rsal.server.Messages.EarlierSweep;
import rsal.settings.InvalidSettings;

/// Sweeps that are in a folder from before, by this server or by `rsal sweep`, each in a folder of its own. Reads only.
/// All methods may be called from any thread.
record EarlierSweeps(Path folder) {
    private static final int MOST = 50; // all of their rows are read

    private record Changed(Path sweep, long when) {}

    /// The newest, without one that is shown elsewhere, and without those that can't be read.
    ///
    /// @throws Refusal when the folder can't be read
    List<EarlierSweep> list(Optional<Path> but) {
        return folders().stream()
                .filter(sweep -> but.isEmpty() || !sweep.equals(but.get()))
                .map(sweep -> new Changed(sweep, changed(sweep))) // asked once, as it may change meanwhile
                .sorted(Comparator.comparingLong(Changed::when).reversed())
                .limit(MOST)
                .flatMap(changed -> describe(changed.sweep()).stream())
                .toList();
    }

    /// The page that `rsal report` writes.
    ///
    /// @param name of a sweep's folder
    /// @throws Refusal when there is none, or nothing to report yet
    String report(String name) {
        Path sweep = folders().stream()
                .filter(one -> name(one).equals(name)) // compared, not resolved: a name leads to no other folder
                .findFirst()
                .orElseThrow(() -> new Refusal(404, "There is no sweep (%s).".formatted(Refusal.shortened(name))));
        Findings findings =
                read(sweep).orElseThrow(() -> new Refusal(409, "The sweep in (%s) can't be read.".formatted(sweep)));
        if (findings.rows().isEmpty()) {
            throw new Refusal(409, "No run has ended.");
        }
        return Report.html(findings);
    }

    private List<Path> folders() {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(sweep -> Files.isRegularFile(sweep.resolve(SweepFolder.MANIFEST)))
                    .toList();
        } catch (IOException e) {
            throw new Refusal(409, "Earlier sweeps can't be read (%s): %s.".formatted(folder, e.getMessage()));
        }
    }

    private static String name(Path sweep) {
        return String.valueOf(sweep.getFileName());
    }

    /// When it got its last row, or was begun [ms since 1970].
    private static long changed(Path sweep) {
        Path rows = sweep.resolve(SweepFolder.ROWS);
        try {
            return Files.getLastModifiedTime(Files.exists(rows) ? rows : sweep).toMillis();
        } catch (IOException _) { // somebody takes it away
            return 0;
        }
    }

    private static Optional<Findings> read(Path sweep) {
        try {
            return Optional.of(Findings.read(sweep));
        } catch (InvalidSettings | UncheckedIOException _) {
            return Optional.empty();
        }
    }

    private static Optional<EarlierSweep> describe(Path sweep) {
        return read(sweep)
                .filter(findings -> !findings.manifest().sessions().isEmpty())
                .map(findings -> {
                    Manifest.Session last = findings.manifest().sessions().getLast();
                    return new EarlierSweep(
                            name(sweep),
                            findings.manifest().title(),
                            last.started(),
                            findings.design().trials().size(),
                            findings.rows().size(),
                            ShellWords.of(last.command()));
                });
    }
}
