package rsal.agent;

import java.util.Set;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A language in which people write agents, as AgentSpeak. A scenario names the file of such an agent where it names
/// a type else (`type: hunter.asl`).
public interface AgentLanguage {
    /// How its files' names end: `.asl`.
    String suffix();

    /// Names that mean something else in it, as `self`: agents that run beside those written in it can't have them.
    default Set<String> takenNames() {
        return Set.of();
    }

    /// Reads an agent's file.
    ///
    /// @param path of it among the files
    /// @param askedAt where it is named
    /// @return a type whose key is the path
    /// @throws InvalidSettings with the mistakes in it, or when it can't be read
    AgentType read(String path, FileSource files, Location askedAt);
}
