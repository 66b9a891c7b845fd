package rsal.settings;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;

/// Guesses which file was meant by the name of one that is not there.
final class NearbyFiles {
    private static final int MAX_NAMES = 10_000; // of a folder

    private NearbyFiles() {}

    /// A sentence; empty when nothing beside it has a name like it.
    ///
    /// @param folder outside of which nothing is looked at
    static Optional<String> maybe(Path folder, String path) {
        try {
            Path root = folder.toRealPath();
            Path asked = root.resolve(path).normalize();
            Path name = asked.getFileName();
            Path parent = asked.getParent();
            if (name == null || parent == null || !parent.toRealPath().startsWith(root)) {
                return Optional.empty();
            }
            try (Stream<Path> files = Files.list(parent)) {
                return Suggestion.closest(
                                name.toString(),
                                files.limit(MAX_NAMES)
                                        .filter(Files::isRegularFile)
                                        .map(file -> String.valueOf(file.getFileName()))
                                        .sorted()
                                        .toList())
                        .map(close -> "Maybe '%s' was meant?".formatted(close));
            }
        } catch (IOException | InvalidPathException _) {
            return Optional.empty();
        }
    }
}
