package rsal.agent;

import java.util.Optional;
import java.util.Set;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// A language in which people write agents, as AgentSpeak. A scenario names the file of such an agent where it
/// names a type else (`type: hunter.asl`). Found by [java.util.ServiceLoader]. Its agents use nothing but their
/// [AgentContext], so that they run on each agent platform, beside agents in other languages.
public interface AgentLanguage {
    /// How its files' names end: `.asl`.
    String suffix();

    /// Whether what a scenario names as a type is an agent's file in this language.
    default boolean reads(String type) {
        return type.endsWith(suffix());
    }

    /// The pattern of what a scenario names as a type in this language, for the schema of scenarios.
    default String pattern() {
        return suffix().replace(".", "\\.") + "$";
    }

    /// The file that such a type is in; empty when it is in none of the scenario's.
    default Optional<String> file(String type) {
        return Optional.of(type);
    }

    /// Names that mean something else in it, as `self`: no agent of a scenario that uses it can have them.
    default Set<String> takenNames() {
        return Set.of();
    }

    /// Whether its files are programs that may do whatever this process may, also when they are only read. Such
    /// files are read from where a person keeps them ([FileSource#isTrusted]), never from a recording, which
    /// anybody may have made.
    default boolean runsCode() {
        return false;
    }

    /// Why no file in it can be read on this machine, and what to do, in sentences; empty where they can be.
    default Optional<String> unavailable() {
        return Optional.empty();
    }

    /// Many runs are to come, of which some may have agents in it: what each needs may be begun ahead, until that is
    /// closed. Nothing by default.
    ///
    /// @param atOnce how many runs go on side by side
    /// @param inAll how many there will be
    default RunPreparation prepare(int atOnce, int inAll) {
        return () -> {};
    }

    /// Reads an agent's file.
    ///
    /// @param path of it among the files
    /// @param askedAt where it is named
    /// @return a type whose key is the path
    /// @throws InvalidSettings with the errors in it, or when it can't be read
    AgentType read(String path, FileSource files, Location askedAt);
}
