package rsal.cli.show;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import rsal.cli.terminal.Destination;
import rsal.recording.Recording;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Opens recordings that people name.
public final class RecordingFile {
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
            throw new InvalidSettings(Location.of(name), "There is no file '%s'.".formatted(name), "");
        } catch (IOException e) {
            throw new InvalidSettings(
                    Location.of(name), "This recording can't be read: %s".formatted(e.getMessage()), "");
        }
    }
}
