package rsal.python;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// The text of an agent's file and of the modules beside it that it imports, as they were when they were read.
/// Immutable.
///
/// @param path of the agent's file
/// @param className of the agent; empty when the file has one only
/// @param texts of all its files, by path
record PythonSources(String path, String className, Map<String, String> texts) {
    static final String SUFFIX = ".py";
    private static final int MAX_BYTES = 1 << 20;
    private static final int MOST_FILES = 200;
    private static final Pattern COMMA = Pattern.compile("\\s*,\\s*");
    private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");

    /// What a module may import. There need not be such a file.
    private static final Pattern IMPORT =
            Pattern.compile("(?m)^[ \\t]*(?:from|import)[ \\t]+(\\w+(?:[ \\t]*,[ \\t]*\\w+)*)");

    PythonSources {
        texts = Collections.unmodifiableMap(new LinkedHashMap<>(texts));
    }

    /// @param type path of the file, and the name of the class after a colon
    /// @throws InvalidSettings when the file can't be read, or it needs too many others
    static PythonSources read(String type, FileSource files, Location askedAt) {
        int colon = type.indexOf(SUFFIX + ":");
        String path = colon < 0 ? type : type.substring(0, colon + SUFFIX.length());
        String className = colon < 0 ? "" : type.substring(colon + SUFFIX.length() + 1);
        String folder = path.substring(0, path.lastIndexOf('/') + 1);
        String module = path.substring(folder.length(), path.length() - SUFFIX.length());
        if (!NAME.matcher(module).matches()
                || !(className.isEmpty() || NAME.matcher(className).matches())) {
            throw new InvalidSettings(
                    askedAt,
                    "A module of Python can't be called '%s'.".formatted(type.substring(folder.length())),
                    "Use letters, digits and '_', as hunter.py, or hunter.py:Hunter with the name of a class.");
        }
        var texts = new LinkedHashMap<String, String>();
        texts.put(path, files.text(path, MAX_BYTES, askedAt));
        var asked = new HashSet<>(texts.keySet());
        var unread = new ArrayDeque<>(texts.values());
        while (!unread.isEmpty()) {
            Matcher imports = IMPORT.matcher(unread.remove());
            while (imports.find()) {
                for (String name : COMMA.splitAsStream(imports.group(1)).toList()) {
                    String other = folder + name + SUFFIX;
                    if (asked.add(other)) {
                        readable(other, files, askedAt).ifPresent(text -> {
                            texts.put(other, text);
                            unread.add(text);
                        });
                    }
                }
            }
            if (texts.size() > MOST_FILES) {
                throw new InvalidSettings(askedAt, "'%s' needs more than %d files.".formatted(path, MOST_FILES), "");
            }
        }
        return new PythonSources(path, className, texts);
    }

    private static Optional<String> readable(String path, FileSource files, Location askedAt) {
        try {
            return Optional.of(files.text(path, MAX_BYTES, askedAt));
        } catch (InvalidSettings _) { // most modules are installed ones
            return Optional.empty();
        }
    }

    String text() {
        return texts.getOrDefault(path, "");
    }
}
