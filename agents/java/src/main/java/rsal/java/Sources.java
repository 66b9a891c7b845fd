package rsal.java;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.lang.model.SourceVersion;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// The text of a file and of the files in its folder that it needs, as they were when they were read.
/// Immutable.
///
/// @param path of the file that is asked for
/// @param texts of all its files, by path
record Sources(String path, Map<String, String> texts) {
    static final String SUFFIX = ".java";
    private static final int MAX_BYTES = 1 << 20;
    private static final int MOST_FILES = 200;

    /// What may be the name of a class in another file. There need not be such a file.
    private static final Pattern NAME = Pattern.compile("\\b\\p{javaUpperCase}\\w*\\b");

    private static final Pattern PACKAGE = Pattern.compile("(?m)^\\s*package\\s+([\\w.]+)\\s*;");
    private static final Pattern DOC =
            Pattern.compile("(?m)^///\\s*(\\S.*)$|^/\\*\\*\\s*\\n?\\s*\\*?\\s*(\\S[^*\\n]*)");

    Sources {
        texts = Collections.unmodifiableMap(new LinkedHashMap<>(texts));
    }

    /// @throws InvalidSettings when the file can't be read, or it needs too many others
    static Sources read(String path, FileSource files, Location askedAt) {
        String folder = path.substring(0, path.lastIndexOf('/') + 1);
        String name = path.substring(folder.length());
        if (!SourceVersion.isIdentifier(name.substring(0, name.length() - SUFFIX.length()))) {
            throw new InvalidSettings(
                    askedAt, "A Java file can't be called '%s'.".formatted(name), "Give it the name of its class.");
        }
        var texts = new LinkedHashMap<String, String>();
        texts.put(path, files.text(path, MAX_BYTES, askedAt));
        var asked = new HashSet<>(texts.keySet());
        var unread = new ArrayDeque<>(texts.values());
        while (!unread.isEmpty()) {
            Matcher names = NAME.matcher(unread.remove());
            while (names.find()) {
                String other = folder + names.group() + SUFFIX;
                if (asked.add(other)) {
                    readable(other, files, askedAt).ifPresent(text -> {
                        texts.put(other, text);
                        unread.add(text);
                    });
                }
            }
            if (texts.size() > MOST_FILES) {
                throw new InvalidSettings(askedAt, "'%s' needs more than %d files.".formatted(path, MOST_FILES), "");
            }
        }
        return new Sources(path, texts);
    }

    private static Optional<String> readable(String path, FileSource files, Location askedAt) {
        try {
            return Optional.of(files.text(path, MAX_BYTES, askedAt));
        } catch (InvalidSettings _) { // most names are of other classes; the compiler tells what is missing
            return Optional.empty();
        }
    }

    /// `Hunter` of `agents/Hunter.java`.
    String simpleName() {
        return path.substring(path.lastIndexOf('/') + 1, path.length() - SUFFIX.length());
    }

    /// With the package that the file says it is in.
    String className() {
        Matcher found = PACKAGE.matcher(text());
        return found.find() ? found.group(1) + "." + simpleName() : simpleName();
    }

    /// What its author says of it first; empty for nothing.
    String description() {
        Matcher found = DOC.matcher(text());
        return found.find()
                ? Optional.ofNullable(found.group(1))
                        .orElseGet(() -> found.group(2))
                        .strip()
                : "";
    }

    private String text() {
        return texts.getOrDefault(path, "");
    }
}
