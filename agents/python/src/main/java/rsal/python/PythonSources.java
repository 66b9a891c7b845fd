package rsal.python;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// The text of an agent's file and of the modules beside it that it imports, as they were when they were read. A module
/// beside it may be in a folder (`parts/scan.py` is `parts.scan`). Of an agent in an installed package there are no
/// texts. Immutable.
///
/// @param path of the agent's file; of an installed one its type
/// @param module of the agent, as Python imports it
/// @param className of the agent; empty when the file has one only
/// @param texts of all its files, by path
record PythonSources(String path, String module, String className, Map<String, String> texts) {
    static final String SUFFIX = ".py";
    private static final String INSTALLED = "python:";
    private static final String PACKAGE = "/__init__" + SUFFIX;
    private static final int MAX_BYTES = 1 << 20;
    private static final int MOST_FILES = 200;
    private static final Set<String> NOT_BESIDE = Set.of("rsal", "numpy"); // what comes with RSAL is not looked for
    private static final Pattern COMMA = Pattern.compile("\\s*,\\s*");
    private static final Pattern BETWEEN = Pattern.compile("[,\\n]\\s*");
    private static final Pattern DOT = Pattern.compile("\\.");
    private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");
    private static final Pattern TYPE = Pattern.compile(INSTALLED + "(\\w+(?:\\.\\w+)*):([A-Za-z_]\\w*)");

    private static final Pattern COMMENT = Pattern.compile("#.*");
    private static final Pattern CONTINUED = Pattern.compile("\\\\\\r?\\n");

    /// What a module may import: `import a.b as d, c`, also after `;` or `:`. There need not be such files.
    private static final Pattern IMPORT = Pattern.compile("(?m)(?:^|[;:])[ \\t]*import[ \\t]+([\\w.]+[\\w., \\t]*)");

    /// `from .a import b, c`, also with parentheses over several lines.
    private static final Pattern FROM = Pattern.compile(
            "(?m)(?:^|[;:])[ \\t]*from[ \\t]+([\\w.]+)[ \\t]+import[ \\t]+(?:\\(([^)]*)\\)|([\\w, \\t]+))");

    PythonSources {
        texts = Collections.unmodifiableMap(new LinkedHashMap<>(texts));
    }

    static boolean isInstalled(String type) {
        return type.startsWith(INSTALLED);
    }

    /// Of the file that a type names.
    static String path(String type) {
        int colon = type.indexOf(SUFFIX + ":");
        return colon < 0 ? type : type.substring(0, colon + SUFFIX.length());
    }

    boolean isInstalled() {
        return isInstalled(path);
    }

    /// @param type path of the file, and the name of the class after a colon; or that of an installed one
    /// @throws InvalidSettings when the file can't be read, or it needs too many others
    static PythonSources read(String type, FileSource files, Location askedAt) {
        if (isInstalled(type)) {
            Matcher named = TYPE.matcher(type);
            if (!named.matches()) {
                throw new InvalidSettings(
                        askedAt,
                        "'%s' names no class of an installed package.".formatted(type),
                        "Write 'python:package.module:Class'.");
            }
            return new PythonSources(type, named.group(1), named.group(2), Map.of());
        }
        String path = path(type);
        String className = path.length() == type.length() ? "" : type.substring(path.length() + 1);
        String folder = path.substring(0, path.lastIndexOf('/') + 1);
        String module = path.substring(folder.length(), path.length() - SUFFIX.length());
        if (!NAME.matcher(module).matches()
                || !(className.isEmpty() || NAME.matcher(className).matches())) {
            throw new InvalidSettings(
                    askedAt,
                    "A module of Python can't be called '%s'.".formatted(type.substring(folder.length())),
                    "Use letters, digits and '_', as hunter.py, or hunter.py:Hunter with the name of a class.");
        }
        var beside = new Beside(folder, files, askedAt);
        beside.add(path, files.text(path, MAX_BYTES, askedAt));
        beside.follow();
        return new PythonSources(path, module, className, beside.texts);
    }

    /// In which its files are, with a `/` at the end; empty where the scenario is.
    String folder() {
        return isInstalled() ? "" : path.substring(0, path.lastIndexOf('/') + 1);
    }

    /// Its files, as they are named in their folder.
    List<String> files() {
        return texts.keySet().stream()
                .map(each -> each.substring(folder().length()))
                .toList();
    }

    String text() {
        return texts.getOrDefault(path, "");
    }

    /// The files beside an agent's.
    private static final class Beside {
        private final String folder;
        private final FileSource files;
        private final Location askedAt;
        private final Map<String, String> texts = new LinkedHashMap<>(); // by path
        private final Set<String> asked = new HashSet<>(); // paths
        private final Deque<String> unread = new ArrayDeque<>(); // paths

        Beside(String folder, FileSource files, Location askedAt) {
            this.folder = folder;
            this.files = files;
            this.askedAt = askedAt;
        }

        void add(String path, String text) {
            asked.add(path);
            texts.put(path, text);
            unread.add(path);
            if (texts.size() > MOST_FILES) {
                throw new InvalidSettings(
                        askedAt,
                        "'%s' needs more than %d files."
                                .formatted(texts.keySet().iterator().next(), MOST_FILES),
                        "");
            }
        }

        void follow() {
            while (!unread.isEmpty()) {
                String path = unread.remove();
                String text = CONTINUED
                        .matcher(COMMENT.matcher(texts.getOrDefault(path, "")).replaceAll(""))
                        .replaceAll(" ");
                String own = path.substring(folder.length()); // parts/scan.py
                int slash = own.lastIndexOf('/');
                String parent = slash < 0 ? "" : own.substring(0, slash).replace('/', '.'); // parts
                for (Matcher found = IMPORT.matcher(text); found.find(); ) {
                    COMMA.splitAsStream(found.group(1))
                            .map(each -> each.strip().replaceFirst("\\s.*", "")) // as another name
                            .forEach(this::lookFor);
                }
                for (Matcher found = FROM.matcher(text); found.find(); ) {
                    String from = absolute(found.group(1), parent);
                    lookFor(from);
                    String names = found.group(2) == null ? found.group(3) : found.group(2);
                    BETWEEN.splitAsStream(names)
                            .map(String::strip)
                            .map(NAME::matcher)
                            .filter(Matcher::lookingAt) // without 'as other', and a comment
                            .map(Matcher::group)
                            .forEach(name -> lookFor(from.isEmpty() ? name : from + "." + name));
                }
            }
        }

        /// `parts.scan` for `.scan` in a file of `parts`.
        private static String absolute(String from, String parent) {
            if (!from.startsWith(".")) {
                return from;
            }
            String up = parent;
            int dots = 1;
            for (; dots < from.length() && from.charAt(dots) == '.'; dots++) {
                up = up.contains(".") ? up.substring(0, up.lastIndexOf('.')) : "";
            }
            String rest = from.substring(dots);
            return up.isEmpty() ? rest : rest.isEmpty() ? up : up + "." + rest;
        }

        /// A module and the packages that it is in. Most are installed ones, and not here.
        private void lookFor(String module) {
            List<String> names = DOT.splitAsStream(module).toList();
            if (NOT_BESIDE.contains(names.getFirst())) {
                return;
            }
            var path = new StringBuilder(folder);
            for (String name : names) {
                path.append(path.length() == folder.length() ? "" : "/").append(name);
                if (!NAME.matcher(name).matches() || lookFor(path, SUFFIX)) {
                    return;
                }
                lookFor(path, PACKAGE);
            }
        }

        private boolean lookFor(CharSequence module, String suffix) {
            String path = module + suffix;
            if (asked.add(path)) {
                readable(path).ifPresent(text -> add(path, text));
            }
            return texts.containsKey(path);
        }

        private Optional<String> readable(String path) {
            try {
                return Optional.of(files.text(path, MAX_BYTES, askedAt));
            } catch (InvalidSettings _) {
                return Optional.empty();
            }
        }
    }
}
