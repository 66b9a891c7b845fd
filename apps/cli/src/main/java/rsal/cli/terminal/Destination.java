package rsal.cli.terminal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A folder that a command is to write files to. It is looked at before the work, which may take an hour.
public final class Destination {
    private final Path folder;

    private Destination(Path folder) {
        this.folder = folder;
    }

    /// Nothing is made or changed by asking.
    ///
    /// @param names of the files
    /// @param force whether files that are there may be lost
    /// @throws InvalidSettings when something is in the way
    public static Destination of(String folder, Collection<String> names, boolean force) {
        Path path = path(folder);
        if (Files.exists(path) && !Files.isDirectory(path)) {
            throw new InvalidSettings(Location.of(folder), "This is a file, not a folder to write to.", "");
        }
        for (String name : names) {
            if (!force && Files.exists(path.resolve(name))) {
                throw new InvalidSettings(
                        Location.of(path.resolve(name).toString()),
                        "The file is there already.",
                        "Name another, or overwrite it by '--force'.");
            }
        }
        return new Destination(path);
    }

    public static Path path(String name) {
        try {
            return Path.of(name);
        } catch (InvalidPathException e) {
            throw new InvalidSettings(Location.of(name), "This can't be the name of a file or folder.", "");
        }
    }

    /// Tries whether files could be written to the folder, or, where it is not there yet, to the one it would be made
    /// in. Nothing is left of that.
    ///
    /// @throws InvalidSettings when they can't
    public Destination prepare() {
        Path there = folder.toAbsolutePath();
        while (there.getParent() != null && !Files.exists(there)) {
            there = there.getParent();
        }
        try {
            Files.delete(Files.createTempFile(there, ".rsal", ".part"));
            return this;
        } catch (IOException e) {
            throw refused(e);
        }
    }

    /// The same for a folder that must be there.
    public Destination prepareExisting() {
        require(folder);
        return prepare();
    }

    /// @throws InvalidSettings when the folder is not there
    public static void require(Path folder) {
        if (!Files.isDirectory(folder)) {
            throw new InvalidSettings(Location.of(folder.toString()), "There is no such folder.", "Make it first.");
        }
    }

    /// Makes the folder, unless it is there, and writes the files.
    ///
    /// @param contents of the files by their names
    public void write(Map<String, byte[]> contents) {
        try {
            Files.createDirectories(folder);
            for (var file : contents.entrySet()) {
                Files.write(folder.resolve(file.getKey()), file.getValue());
            }
        } catch (IOException e) {
            throw refused(e);
        }
    }

    public Path resolve(String name) {
        return folder.resolve(name);
    }

    private InvalidSettings refused(IOException e) {
        return new InvalidSettings(
                Location.of(folder.toString()),
                "Nothing can be written to this folder (%s: %s)."
                        .formatted(e.getClass().getSimpleName(), e.getMessage()),
                "Name one that you may write to.");
    }
}
