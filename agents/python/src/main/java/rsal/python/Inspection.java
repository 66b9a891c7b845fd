package rsal.python;

import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SequencedMap;
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
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    private static final SequencedMap<Asked, Map<?, ?>> KNOWN = new LinkedHashMap<>();

    /// @param module of an installed one; empty of a file
    /// @param files all, as they are named in their folder
    private record Asked(String path, String module, String className, String text, List<String> files) {}

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
                        sources.text(),
                        sources.files()),
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
            if (known != null) {
                KNOWN.putLast(asked, known);
                return known;
            }
        }
        Map<?, ?> found = ask(asked, askedAt); // not on the lock: it takes a tenth of a second, or hangs
        synchronized (KNOWN) {
            boolean needsAnother = found.get("class") == null; // packages may be installed, and errors repaired
            if (!needsAnother && asked.module.isEmpty()) { // a package may be changed where it is installed
                KNOWN.putLast(asked, found);
            }
            if (KNOWN.size() > MOST_KNOWN) {
                KNOWN.pollFirstEntry();
            }
        }
        return found;
    }

    private static Map<?, ?> ask(Asked asked, Location askedAt) {
        Process process;
        try {
            process = Interpreter.start("inspection");
        } catch (IOException e) {
            throw unusable(askedAt, asked.path, String.valueOf(e.getMessage()));
        }
        try (var time = AnswerTime.of(process, PATIENCE)) {
            return ask(asked, askedAt, process, time);
        } finally {
            process.destroyForcibly();
        }
    }

    private static Map<?, ?> ask(Asked asked, Location askedAt, Process process, AnswerTime time) {
        try {
            var frames = new FramePipe(process.getInputStream(), process.getOutputStream());
            frames.write(to -> to.put("path", asked.path)
                    .put("module", asked.module)
                    .put("class", asked.className)
                    .put("text", asked.text)
                    .put("files", asked.files));
            return frames.read();
        } catch (IOException e) {
            String why = e instanceof EOFException ? words(process) : String.valueOf(e.getMessage());
            throw unusable(askedAt, asked.path, time.isOver() ? time.words() : why);
        }
    }

    private static String words(Process process) {
        try {
            return new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8)
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
