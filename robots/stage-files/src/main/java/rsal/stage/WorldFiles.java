package rsal.stage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.settings.Suggestion;

/// Where the files of a world are looked for: as Stage does beside the world itself and in the folders of
/// `STAGEPATH`, and between the two beside the file that names them.
public final class WorldFiles {
    private static final int MAX_NAMES = 10_000; // of a folder, to guess what was meant

    private final FileSource source;
    private final List<String> searchPath;
    private final Function<String, List<String>> names;

    private WorldFiles(FileSource source, List<String> searchPath, Function<String, List<String>> names) {
        this.source = source;
        this.searchPath = List.copyOf(searchPath);
        this.names = names;
    }

    /// Files that never lie outside of a source.
    public static WorldFiles in(FileSource source) {
        return new WorldFiles(source, List.of(), folder -> List.of());
    }

    /// All files on disk that this process may read: for a world that a person names on the command line.
    ///
    /// @param searchPath folders, as in `STAGEPATH`
    public static WorldFiles onDisk(List<String> searchPath) {
        return new WorldFiles(FileSource.disk(), searchPath, WorldFiles::namesOnDisk);
    }

    /// A file that was found.
    ///
    /// @param path as the person who named the world would write it
    public record Found(String path, byte[] bytes) {}

    /// The world itself.
    Found open(String path, int most) {
        try {
            return new Found(path, source.read(path, most, Location.of(path)));
        } catch (InvalidSettings e) {
            Problem why = e.problems().getFirst();
            throw isThere(path)
                    ? e
                    : new InvalidSettings(
                            why.location(), why.message(), guess(path, names.apply(folder(path)), why.remedy()));
        }
    }

    /// A file that a world names.
    ///
    /// @param world the world's own path
    /// @param askedAt where it is named
    /// @throws InvalidSettings when it is nowhere or can't be read
    public Found find(String name, String world, int most, Location askedAt) {
        var why = new LinkedHashSet<String>();
        Optional<Problem> unreadable = Optional.empty(); // of the first that is there
        for (String candidate : candidates(name, world, askedAt.file())) {
            try {
                return new Found(candidate, source.read(candidate, most, askedAt));
            } catch (InvalidSettings e) {
                Problem problem = e.problems().getFirst();
                why.add(problem.message());
                unreadable = unreadable.or(() -> isThere(candidate) ? Optional.of(problem) : Optional.empty());
            }
        }
        if (unreadable.isPresent()) {
            throw new InvalidSettings(List.of(unreadable.get()));
        }
        throw new InvalidSettings(askedAt, String.join(" ", why), remedy(name, world, askedAt.file()));
    }

    private boolean isThere(String path) {
        String last = lastName(path);
        return last.equals(".")
                || last.equals("..")
                || names.apply(folder(path)).contains(last);
    }

    private List<String> candidates(String name, String world, String asking) {
        var paths = new LinkedHashSet<String>();
        if (name.startsWith("/")) {
            paths.add(normal(name));
        } else {
            paths.add(normal(folder(world) + name));
            paths.add(normal(folder(asking) + name));
        }
        for (String folder : searchPath) {
            paths.add(normal(folder + "/" + name));
            paths.add(normal(folder + "/" + lastName(name)));
        }
        return List.copyOf(paths);
    }

    private String remedy(String name, String world, String asking) {
        var known = new LinkedHashSet<String>();
        for (String path : candidates(name, world, asking)) {
            known.addAll(names.apply(folder(path)));
        }
        return guess(
                name, known, "Maybe it is in another folder: those in the environment's STAGEPATH are searched, too.");
    }

    private static String guess(String path, Collection<String> known, String otherwise) {
        return Suggestion.closest(lastName(path), known)
                .map(file -> "Maybe '%s' was meant?".formatted(file))
                .orElse(otherwise);
    }

    private static String lastName(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }

    /// The folder of a path with its slash; empty when there is none.
    private static String folder(String path) {
        return path.substring(0, path.lastIndexOf('/') + 1);
    }

    /// The same path without `.`, and without `..` where it leads out of a folder that the path names.
    private static String normal(String path) {
        var parts = new ArrayDeque<String>();
        for (String part : path.split("/", -1)) {
            if (part.equals("..") && !parts.isEmpty() && !parts.getLast().equals("..")) {
                parts.removeLast();
            } else if (!part.isEmpty() && !part.equals(".")) {
                parts.addLast(part);
            }
        }
        String normal = (path.startsWith("/") ? "/" : "") + String.join("/", parts);
        return normal.isEmpty() ? "." : normal;
    }

    private static List<String> namesOnDisk(String folder) {
        var names = new ArrayList<String>();
        try (Stream<Path> files = Files.list(Path.of(folder.isEmpty() ? "." : folder))) {
            files.limit(MAX_NAMES)
                    .map(file -> String.valueOf(file.getFileName()))
                    .sorted()
                    .forEach(names::add);
        } catch (IOException | InvalidPathException _) {
            return List.of(); // nothing to guess from
        }
        return names;
    }
}
