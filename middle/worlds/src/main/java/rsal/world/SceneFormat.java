package rsal.world;

import java.util.List;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;

/// A way to write worlds, found by [java.util.ServiceLoader].
public interface SceneFormat {
    /// How the names of its files end, with the dot: `.world`.
    String suffix();

    /// How names of its files end that another format's do, too. Of files with such names it reads those that it
    /// [#recognizes].
    default List<String> sharedSuffixes() {
        return List.of();
    }

    /// Whether a file whose name is not enough to tell is of this format.
    default boolean recognizes(byte[] content) {
        return false;
    }

    /// @param path of the file, as a person writes it
    /// @param files where it and what it names is
    /// @param seed for what the file leaves to chance
    /// @throws InvalidSettings with all errors of the file
    Scene read(String path, FileSource files, long seed);
}
