package rsal.server.sweep;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.experiment.ExperimentOutline;
import rsal.experiment.Findings;
import rsal.experiment.Manifest;
import rsal.experiment.SweepFolder;
import rsal.experiment.report.Report;
import rsal.experiment.report.ShellWords;
import rsal.server.http.FewAtOnce;
import rsal.server.message.Messages.EarlierSweep;
import rsal.server.message.Refusal;
import rsal.settings.InvalidSettings;

/// Sweeps that are in a folder from before, by this server or by `rsal sweep`, each in a folder of its own. Reads only.
/// Everybody who can reach the port may ask, without a token: so what was worked out is kept until files change, it is
/// done for one at a time, and few may wait for that. All methods may be called from any thread.
final class EarlierSweeps {
    private static final int MOST = 50;

    private final Path folder;
    private final FewAtOnce few = new FewAtOnce("earlier sweeps");
    private Map<Path, Known> known = Map.of(); // of the last list
    private @Nullable Written report; // the last one that was asked for

    /// @param when its files changed last
    private record Known(Changed when, Optional<EarlierSweep> reported) {}

    private record Written(Path sweep, Changed when, String html) {}

    /// When files of a sweep were written last [ms since 1970]; 0 what is not there.
    private record Changed(long manifest, long rows) {
        static Changed of(Path sweep) {
            return new Changed(written(sweep, SweepFolder.MANIFEST), written(sweep, SweepFolder.ROWS));
        }

        private static long written(Path sweep, String file) {
            return sweep.resolve(file).toFile().lastModified();
        }
    }

    private record Found(Path sweep, Changed when) {
        long last() {
            return Math.max(when.manifest(), when.rows());
        }
    }

    EarlierSweeps(Path folder) {
        this.folder = folder;
    }

    /// The newest, without one that is shown elsewhere, and without those that can't be read.
    ///
    /// @throws Refusal when the folder can't be read, or others are asking
    List<EarlierSweep> list(Optional<Path> but) {
        return few.ask(() -> newest(but));
    }

    private synchronized List<EarlierSweep> newest(Optional<Path> but) {
        var newest = new LinkedHashMap<Path, Known>();
        folders().stream()
                .filter(sweep -> but.isEmpty() || !sweep.equals(but.get()))
                .map(sweep -> new Found(sweep, Changed.of(sweep))) // asked once, as it may change meanwhile
                .sorted(Comparator.comparingLong(Found::last).reversed())
                .limit(MOST)
                .forEach(found -> newest.put(found.sweep(), describe(found)));
        known = newest;
        return newest.values().stream()
                .flatMap(sweep -> sweep.reported().stream())
                .toList();
    }

    private Known describe(Found found) {
        Known before = known.get(found.sweep());
        return before != null && before.when().equals(found.when())
                ? before
                : new Known(found.when(), describe(found.sweep()));
    }

    private static Optional<EarlierSweep> describe(Path sweep) {
        try {
            ExperimentOutline outline = ExperimentOutline.read(sweep);
            List<Manifest.Session> sessions = outline.manifest().sessions();
            if (sessions.isEmpty()) {
                return Optional.empty();
            }
            return Optional.of(new EarlierSweep(
                    name(sweep),
                    outline.manifest().title(),
                    sessions.getLast().started(),
                    outline.runs(),
                    outline.ended(),
                    ShellWords.of(sessions.getLast().command())));
        } catch (InvalidSettings | UncheckedIOException _) {
            return Optional.empty();
        }
    }

    /// The page that `rsal report` writes.
    ///
    /// @param name of a sweep's folder
    /// @throws Refusal when there is none, or nothing to report yet, or others are asking
    String report(String name) {
        return few.ask(() -> written(name));
    }

    /// Where one of them is.
    ///
    /// @param name of its folder
    /// @throws Refusal when there is none
    Path find(String name) {
        return folders().stream()
                .filter(one -> name(one).equals(name)) // compared, not resolved: a name leads to no other folder
                .findFirst()
                .orElseThrow(() -> new Refusal(404, "There is no sweep '%s'.".formatted(Refusal.shortened(name))));
    }

    private synchronized String written(String name) {
        Path sweep = find(name);
        Changed when = Changed.of(sweep);
        Written before = report;
        if (before == null || !before.sweep().equals(sweep) || !before.when().equals(when)) {
            before = new Written(sweep, when, write(sweep));
            report = before;
        }
        return before.html();
    }

    private static String write(Path sweep) {
        Findings findings;
        try {
            findings = Findings.read(sweep);
        } catch (InvalidSettings e) {
            throw new Refusal(
                    409, "Its sweep can't be read. %s".formatted(e.problems().getFirst()));
        } catch (UncheckedIOException e) {
            throw new Refusal(409, "The sweep in '%s' can't be read: %s.".formatted(sweep, e.getMessage()));
        }
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
}
