package rsal.cli.log;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import picocli.CommandLine.ParameterException;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Unreachable;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Files that a conversion has made, all of them in memory, to be written together.
final class ConvertedFiles {
    private final Map<Path, byte[]> contents = new LinkedHashMap<>();

    void add(Path file, byte[] content) {
        contents.put(file, content);
    }

    /// Where to write.
    ///
    /// @param ending of the file that is converted, a pattern
    /// @param wanted ending of what is written
    /// @throws ParameterException when another name was typed
    static Path target(Conversion.Request request, String ending, String wanted) {
        String named = request.out().orElseGet(() -> request.file().replaceFirst(ending, wanted));
        try {
            Path target = Path.of(named);
            if (!target.toString().endsWith(wanted)) {
                throw new ParameterException(request.command(), "'%s' must end with %s.".formatted(target, wanted));
            }
            return target;
        } catch (InvalidPathException e) {
            throw new ParameterException(request.command(), "'%s' can't be a file.".formatted(named), e);
        }
    }

    /// The names of all of them.
    List<String> names() {
        return contents.keySet().stream().map(Path::toString).toList();
    }

    /// As if they were there.
    FileSource source() {
        return (path, _, askedAt) -> contents.entrySet().stream()
                .filter(file -> file.getKey().endsWith(path))
                .map(Map.Entry::getValue)
                .findFirst()
                .orElseThrow(() -> new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), ""));
    }

    /// No file is left half written. What breaks while they are written changes none of them; as they are put in
    /// place one after the other, what breaks then may leave some new and others as they were.
    ///
    /// @param force whether files that are there may be lost
    void write(boolean force) {
        checkFree(force);
        var parts = new LinkedHashMap<Path, Path>(); // by what they become
        try {
            for (Map.Entry<Path, byte[]> content : contents.entrySet()) {
                Path path = content.getKey();
                Path part = path.resolveSibling("." + path.getFileName() + ".part");
                parts.put(path, part);
                Files.write(part, content.getValue());
            }
            for (Map.Entry<Path, Path> part : parts.entrySet()) {
                Files.move(part.getValue(), part.getKey(), StandardCopyOption.REPLACE_EXISTING);
            }
        } catch (IOException e) {
            throw new Unreachable("It can't be written: %s.".formatted(e));
        } finally {
            parts.values().forEach(ConvertedFiles::deleteQuietly);
        }
    }

    private void checkFree(boolean force) {
        for (Path path : contents.keySet()) {
            requireFolder(path);
            if (!force && Files.exists(path)) {
                throw isThere(path);
            }
        }
    }

    /// @throws InvalidSettings when the folder is not there that a file is to be written to
    static void requireFolder(Path file) {
        Destination.require(Objects.requireNonNullElse(file.toAbsolutePath().getParent(), file));
    }

    static InvalidSettings isThere(Path path) {
        return new InvalidSettings(
                Location.of(path.toString()), "This file is there already.", "Use --force to overwrite it.");
    }

    private static void deleteQuietly(Path part) {
        try {
            Files.deleteIfExists(part);
        } catch (IOException _) {
            // there is nothing better to do
        }
    }
}
