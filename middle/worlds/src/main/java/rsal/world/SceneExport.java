package rsal.world;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A way to write worlds for other programs, found by [java.util.ServiceLoader].
public interface SceneExport {
    /// How the names of its files end, with the dot: `.sdf`.
    String suffix();

    /// @param name of the world's file without the ending; files beside it begin with it
    /// @param asked where the world is, for messages
    /// @throws InvalidSettings when it can't be written so
    Exported write(Scene scene, String name, Location asked);

    /// What was written.
    ///
    /// @param files by name, the world's first
    /// @param notes what of the world is not in it, a sentence each
    /// @param summary how many of what were written, `12 things, 96 boxes of walls`
    record Exported(Map<String, byte[]> files, List<String> notes, String summary) {
        public Exported {
            files = Collections.unmodifiableMap(new LinkedHashMap<>(files));
            notes = List.copyOf(notes);
        }
    }

    /// The one for files of a name; empty when there is none.
    static Optional<SceneExport> of(String file) {
        return ServiceLoader.load(SceneExport.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(export -> file.endsWith(export.suffix()))
                .findFirst();
    }
}
