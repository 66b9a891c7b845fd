package rsal.python;

import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.SequencedMap;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import rsal.frame.FramePipe;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;

/// What the text of an agent's file says of it, which Python reads without running it.
///
/// The newest are known to the whole process, by their texts: a sweep reads its scenario hundreds of times, and a
/// process of Python takes a tenth of a second. Safe for any thread.
final class Inspection {
    private static final int MOST_KNOWN = 64;
    private static final int PATIENCE = 20; // s; of a process that is told to end
    private static final SequencedMap<Asked, Map<?, ?>> KNOWN = new LinkedHashMap<>();

    /// @param module of an installed one; empty of a file
    private record Asked(String path, String module, String className, String text) {}

    private Inspection() {}

    /// `class`, `description`, `parameters` and `needs` of an agent.
    ///
    /// @throws InvalidSettings with all errors in the file, or when there is no Python that could read it
    static Map<?, ?> of(PythonSources sources, Location askedAt) {
        Map<?, ?> found = known(
                new Asked(
                        sources.path(),
                        sources.isInstalled() ? sources.module() : "",
                        sources.className(),
                        sources.text()),
                askedAt);
        var problems = new Problems();
        for (Object each : FromWords.list(found.get("problems"))) {
            Map<?, ?> problem = (Map<?, ?>) each;
            problems.add(
                    new Location(
                            String.valueOf(Objects.requireNonNullElse(found.get("file"), sources.path())),
                            FromWords.integer(problem.get("line")),
                            FromWords.integer(problem.get("column"))),
                    String.valueOf(problem.get("message")),
                    String.valueOf(problem.get("remedy")));
        }
        problems.throwIfAny();
        return found;
    }

    private static Map<?, ?> known(Asked asked, Location askedAt) {
        synchronized (KNOWN) {
            Map<?, ?> known = KNOWN.get(asked);
            Map<?, ?> found = known == null ? ask(asked, askedAt) : known;
            boolean needsAnother = found.get("class") == null; // packages may be installed, and errors repaired
            if (!needsAnother && asked.module.isEmpty()) { // a package may be changed where it is installed
                KNOWN.putLast(asked, found);
            }
            if (KNOWN.size() > MOST_KNOWN) {
                KNOWN.pollFirstEntry();
            }
            return found;
        }
    }

    private static Map<?, ?> ask(Asked asked, Location askedAt) {
        Process process = null;
        try {
            process = Interpreter.start("inspection");
            var frames = new FramePipe(process.getInputStream(), process.getOutputStream());
            frames.write(to -> to.put("path", asked.path)
                    .put("module", asked.module)
                    .put("class", asked.className)
                    .put("text", asked.text));
            Map<?, ?> found = frames.read();
            process.getOutputStream().close();
            process.waitFor(PATIENCE, TimeUnit.SECONDS);
            return found;
        } catch (EOFException _) {
            throw unusable(askedAt, asked.path, words(process));
        } catch (IOException e) {
            throw unusable(askedAt, asked.path, String.valueOf(e.getMessage()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw unusable(askedAt, asked.path, "it was interrupted");
        } finally {
            if (process != null) {
                process.destroyForcibly();
            }
        }
    }

    private static String words(@Nullable Process process) {
        try {
            return process == null
                    ? ""
                    : new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8)
                            .lines()
                            .reduce("it ended", (_, last) -> last);
        } catch (IOException e) {
            return String.valueOf(e.getMessage());
        }
    }

    private static InvalidSettings unusable(Location askedAt, String path, String why) {
        return new InvalidSettings(
                askedAt,
                "Python can't be run for '%s': %s.".formatted(path, why),
                "It needs Python 3.10 or newer with numpy (pip install numpy). Name one by RSAL_PYTHON=/path/to/python3.");
    }
}
