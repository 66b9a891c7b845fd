package rsal.cli.show;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.cli.terminal.Destination;
import rsal.recording.Recording;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Opens recordings that people name.
public final class RecordingFile {
    private static final int MOST_NAMED = 8;

    private RecordingFile() {}

    /// Whether it is called like one.
    static boolean is(String name) {
        return name.endsWith(".mcap");
    }

    /// @param checked whether all of it is read, so that all damage is known
    /// @throws InvalidSettings when it is none, or can't be read
    public static Recording open(String name, boolean checked) {
        try {
            Destination.path(name); // a name that can't be one
            return Recording.open(name, checked);
        } catch (NoSuchFileException _) {
            throw new InvalidSettings(Location.of(name), "There is no file '%s'.".formatted(name), beside(name));
        } catch (IOException e) {
            throw new InvalidSettings(
                    Location.of(name), "This recording can't be read: %s".formatted(e.getMessage()), "");
        }
    }

    /// Which recordings are where it was looked for.
    private static String beside(String name) {
        Path folder = Path.of(name).toAbsolutePath().normalize().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            return "There is no folder '%s'.".formatted(folder);
        }
        try (Stream<Path> files = Files.list(folder)) {
            List<String> recordings = files.map(file -> file.getFileName().toString())
                    .filter(RecordingFile::is)
                    .sorted()
                    .toList();
            return recordings.isEmpty()
                    ? "'%s' has no recording (.mcap).".formatted(folder)
                    : "'%s' has %s%s."
                            .formatted(
                                    folder,
                                    recordings.stream().limit(MOST_NAMED).collect(Collectors.joining(", ")),
                                    recordings.size() > MOST_NAMED
                                            ? " and %d more".formatted(recordings.size() - MOST_NAMED)
                                            : "");
        } catch (IOException | UncheckedIOException e) {
            return "The folder '%s' can't be read.".formatted(folder);
        }
    }
}
