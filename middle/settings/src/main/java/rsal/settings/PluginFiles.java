package rsal.settings;

import java.util.Optional;

/// Where plugins come from that people wrote in files of their own.
public interface PluginFiles {
    /// Where there are none.
    PluginFiles NONE = (_, _, _) -> Optional.empty();

    /// Reads a plugin.
    ///
    /// @param name as it is written; maybe that of an installed plugin
    /// @return empty when this is not the name of a plugin's file
    /// @throws InvalidSettings with the errors in the file, or when it can't be read
    Optional<Plugin> read(PluginKind kind, String name, Location askedAt);

    /// Whether a plugin stands in place of one that is not read, so that nobody knows what can be set of it.
    default boolean isStandIn(Plugin plugin) {
        return false;
    }
}
